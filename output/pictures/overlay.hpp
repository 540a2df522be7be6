// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/pictures/coloring.hpp"

#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>

#include <string>

namespace aneurysm::pictures
{

/// Text and color bar over a renderer's picture.
class Overlay
{
public:
    /// `font`: height of small letters [pixels]
    Overlay(vtkRenderer& renderer, int font);

    /// Two lines at the top: what it is in large letters, its numbers in small ones.
    void set_caption(const std::string& title, const std::string& numbers);
    /// Lines at the bottom left.
    void set_note(const std::string& lines);
    /// Upright, at the lower right; hidden when not visible.
    void set_color_bar(Quantity quantity, const Range& range, bool visible);
    /// Lying, in the middle of a strip that has nothing else.
    void set_lying_color_bar(Quantity quantity, const Range& range);

private:
    void set_bar(Quantity quantity, const Range& range);

    int font_;
    vtkSmartPointer<vtkTextActor> title_;
    vtkSmartPointer<vtkTextActor> numbers_;
    vtkSmartPointer<vtkTextActor> note_;
    vtkSmartPointer<vtkScalarBarActor> bar_;
};

} // namespace aneurysm::pictures
