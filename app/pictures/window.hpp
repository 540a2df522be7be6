// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pictures/worker.hpp"
#include "output/pictures/canvas.hpp"
#include "output/pictures/chart.hpp"
#include "output/pictures/overlay.hpp"
#include "output/pictures/scene.hpp"

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace aneurysm::app
{

/// A window with the artery on the left and two charts on the right.
class Window
{
public:
    Window(const Scenario& scenario, double spacing, Worker& worker, std::int64_t last, int width,
           int height);

    /// Until it is closed. `keys`: pressed by nobody, one by one.
    void run(const std::vector<std::string>& keys);

    std::int64_t frame() const { return snapshot_.record.frame; } ///< that is shown
    /// What it showed when q closed it; null when it was closed otherwise.
    const pictures::Image& picture() const { return closing_; }

private:
    void on_timer();
    void on_key();
    void ignore() {}
    void press(const std::string& key);
    void save() const;
    void update(); ///< from the worker's newest state
    void place_charts();
    std::string note() const;

    const Scenario& scenario_;
    Worker& worker_;
    std::int64_t last_;
    pictures::Scene scene_;
    pictures::Look look_;
    std::array<pictures::Range, 2> ranges_{}; ///< by quantity; they only grow
    pictures::Overlay overlay_;
    pictures::FrameChart impact_;
    pictures::FrameChart wall_;
    vtkSmartPointer<vtkRenderer> charts_;
    vtkSmartPointer<vtkRenderWindow> window_;
    vtkSmartPointer<vtkRenderWindowInteractor> interactor_;
    pictures::Snapshot snapshot_;
    std::vector<FrameRecord> records_;
    std::deque<std::string> keys_;
    pictures::Image closing_;
    bool help_ = false;
    bool changed_ = true;   ///< something that the picture doesn't show yet
    bool reported_ = false; ///< the simulation's error
};

} // namespace aneurysm::app
