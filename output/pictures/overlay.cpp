// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/overlay.hpp"

#include <vtkTextProperty.h>

namespace aneurysm::pictures
{
namespace
{

void set_style(vtkTextProperty& text, int font)
{
    text.SetFontFamilyToArial();
    text.SetFontSize(font);
    text.SetColor(0.12, 0.13, 0.15);
    text.ShadowOff();
    text.ItalicOff();
    text.BoldOff();
}

vtkSmartPointer<vtkTextActor> make_text(vtkRenderer& renderer, int font, const Vec3& place, bool top)
{
    auto text = vtkSmartPointer<vtkTextActor>::New();
    set_style(*text->GetTextProperty(), font);
    if (top) {
        text->GetTextProperty()->SetVerticalJustificationToTop();
    }
    text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    text->SetPosition(place.x, place.y);
    text->SetInput("");
    renderer.AddActor2D(text);
    return text;
}

} // namespace

Overlay::Overlay(vtkRenderer& renderer, int font)
    : font_(font), title_(make_text(renderer, 3 * font / 2, {0.02, 0.985, 0}, true)),
      numbers_(make_text(renderer, font, {0.02, 0.942, 0}, true)),
      note_(make_text(renderer, font, {0.02, 0.02, 0}, false)),
      bar_(vtkSmartPointer<vtkScalarBarActor>::New())
{
    title_->GetTextProperty()->BoldOn();
    bar_->UnconstrainedFontSizeOn();
    bar_->SetNumberOfLabels(6);
    set_style(*bar_->GetLabelTextProperty(), font);
    set_style(*bar_->GetTitleTextProperty(), font);
    bar_->SetVerticalTitleSeparation(font / 2);
    bar_->SetTextPad(font / 4);
    bar_->VisibilityOff();
    renderer.AddActor2D(bar_);
}

void Overlay::set_caption(const std::string& title, const std::string& numbers)
{
    title_->SetInput(title.c_str());
    numbers_->SetInput(numbers.c_str());
}

void Overlay::set_note(const std::string& lines)
{
    note_->SetInput(lines.c_str());
}

void Overlay::set_bar(Quantity quantity, const Range& range)
{
    bar_->SetLookupTable(colors_of(quantity, range));
    bar_->SetTitle(title_of(quantity).c_str());
    bar_->SetLabelFormat("%-#.4g");
}

void Overlay::set_color_bar(Quantity quantity, const Range& range, bool visible)
{
    bar_->SetVisibility(visible);
    if (visible) {
        set_bar(quantity, range);
        bar_->SetOrientationToVertical();
        bar_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
        bar_->SetPosition(0.84, 0.04);
        bar_->SetWidth(0.14);
        bar_->SetHeight(0.30);
        bar_->SetBarRatio(0.22);
    }
}

void Overlay::set_lying_color_bar(Quantity quantity, const Range& range)
{
    bar_->VisibilityOn();
    set_bar(quantity, range);
    bar_->SetTitle(""); // VTK would draw it over the numbers
    note_->GetTextProperty()->SetJustificationToRight();
    note_->SetPosition(0.27, 0.35);
    note_->SetInput(title_of(quantity).c_str());
    bar_->SetOrientationToHorizontal();
    bar_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
    bar_->SetPosition(0.3, 0.05);
    bar_->SetWidth(0.4);
    bar_->SetHeight(0.9);
    bar_->SetBarRatio(0.25);
}

} // namespace aneurysm::pictures
