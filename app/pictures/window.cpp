// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/window.hpp"

#include "app/pictures/studio.hpp"
#include "common/exception.hpp"
#include "output/columns.hpp"
#include "reference/bifurcation.hpp"

#include <vtkCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>

#include <algorithm>
#include <iostream>

namespace aneurysm::app
{
namespace
{

using namespace output;

constexpr int timer_ms = 20;
constexpr double scene_part = 0.64; ///< of the window's width
constexpr int font = 15;            ///< [pixels]

constexpr const char* help_text = "space  pause, go on\n"
                                  "n  one frame\n"
                                  "c  color: speed, pressure\n"
                                  "f  particles, blood surface\n"
                                  "w  wall on, off\n"
                                  "1 front   2 tilted   3 sac   4 sac from above\n"
                                  "s  save this picture\n"
                                  "h  less help\n"
                                  "q  quit\n"
                                  "mouse: turn; wheel: zoom; shift and mouse: move";
constexpr const char* key_text =
    "space pause  n step  c color  f fluid  w wall  1-4 view  s save  h help  q quit";

constexpr std::array key_views{pictures::View::front, pictures::View::tilted, pictures::View::sac,
                               pictures::View::breach};

/// Both, together.
pictures::Range joined(const pictures::Range& a, const pictures::Range& b)
{
    return a.low < a.high ? pictures::Range{std::min(a.low, b.low), std::max(a.high, b.high)} : b;
}

vtkSmartPointer<vtkRenderer> make_white(double from)
{
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetBackground(1, 1, 1);
    renderer->SetViewport(from, 0, 1, 1);
    renderer->InteractiveOff();
    return renderer;
}

} // namespace

Window::Window(const Scenario& scenario, double spacing, Worker& worker, std::int64_t last, int width,
               int height)
    : scenario_(scenario), worker_(worker), last_(last),
      scene_(scenario, reference::vessel_of(scenario), spacing), overlay_(scene_.renderer(), font),
      impact_(pictures::FrameChart::Content::impact, font), wall_(pictures::FrameChart::Content::wall, font),
      charts_(make_white(scene_part)), window_(vtkSmartPointer<vtkRenderWindow>::New()),
      interactor_(vtkSmartPointer<vtkRenderWindowInteractor>::New())
{
    look_.wall_cells = 10; // faster than the pictures of render
    look_.blood_cells = 2;
    scene_.renderer().SetViewport(0, 0, scene_part, 1);
    charts_->AddActor(&impact_.actor());
    charts_->AddActor(&wall_.actor());
    window_->SetMultiSamples(0);
    window_->SetAlphaBitPlanes(1);
    window_->SetSize(width, height);
    window_->SetWindowName(("aneurysm: " + scenario.name).c_str());
    window_->AddRenderer(&scene_.renderer());
    window_->AddRenderer(charts_);
    interactor_->SetRenderWindow(window_);
    const vtkNew<vtkInteractorStyleTrackballCamera> style;
    // An observer takes the place of the style's own keys.
    style->AddObserver(vtkCommand::CharEvent, this, &Window::ignore);
    style->AddObserver(vtkCommand::KeyPressEvent, this, &Window::on_key);
    interactor_->SetInteractorStyle(style);
    interactor_->AddObserver(vtkCommand::TimerEvent, this, &Window::on_timer);
}

void Window::run(const std::vector<std::string>& keys)
{
    keys_.assign(keys.begin(), keys.end());
    interactor_->Initialize();
    update();
    pictures::look(scene_.renderer(), scene_.vessel(), pictures::View::tilted, 0.92, 0.84);
    interactor_->CreateRepeatingTimer(timer_ms);
    interactor_->Start();
}

void Window::on_timer()
{
    const bool idle = worker_.status().idle; // before: what it did until then is taken now
    update();
    const std::string error = worker_.status().error;
    if (!error.empty() && !reported_) {
        std::cerr << "aneurysm: " << error << std::endl;
        reported_ = changed_ = true;
    }
    if (changed_) {
        place_charts();
        overlay_.set_note(note());
        window_->Render();
        changed_ = false;
    } else if (!keys_.empty() && (idle || keys_.front() == "space")) {
        const std::string key = keys_.front();
        keys_.pop_front();
        press(key);
    }
}

void Window::on_key()
{
    press(interactor_->GetKeySym() == nullptr ? "" : interactor_->GetKeySym());
}

void Window::press(const std::string& key)
{
    changed_ = true;
    if (key == "space") {
        worker_.set_running(!worker_.status().running);
    } else if (key == "n") {
        worker_.step();
    } else if (key == "c") {
        look_.quantity = look_.quantity == pictures::Quantity::speed ? pictures::Quantity::pressure
                                                                     : pictures::Quantity::speed;
    } else if (key == "f") {
        look_.state = look_.state == pictures::Look::State::fluid ? pictures::Look::State::particles
                                                                  : pictures::Look::State::fluid;
    } else if (key == "w") {
        look_.wall = !look_.wall;
    } else if (key.size() == 1 && key[0] >= '1' && key[0] <= '4') {
        const pictures::View view = key_views.at(static_cast<std::size_t>(key[0] - '1'));
        pictures::look(scene_.renderer(), scene_.vessel(), view, 0.92, 0.84);
    } else if (key == "h") {
        help_ = !help_;
    } else if (key == "s") {
        save();
    } else if (key == "q") {
        window_->Render();
        closing_ = pictures::picture_of(*window_); // afterwards OpenGL's buffers are gone
        interactor_->TerminateApp();
    }
    if (key == "c" || key == "f" || key == "w") {
        look_.range = ranges_.at(static_cast<std::size_t>(look_.quantity));
        scene_.show(snapshot_, look_);
    }
    overlay_.set_color_bar(look_.quantity, look_.range, look_.state == pictures::Look::State::particles);
}

void Window::save() const
{
    const std::string file = scenario_.name + "_" + std::to_string(frame()) + ".png";
    try {
        pictures::write_png(file, *pictures::picture_of(*window_));
        std::cout << "Saved " << file << std::endl;
    } catch (const std::exception& error) { // no reason to lose the run
        std::cerr << "aneurysm: " << text_of(error) << std::endl;
    }
}

void Window::update()
{
    if (!worker_.take(snapshot_, records_)) {
        return;
    }
    for (const pictures::Quantity quantity : {pictures::Quantity::speed, pictures::Quantity::pressure}) {
        pictures::RangeFinder finder(quantity);
        finder.add(snapshot_.particles);
        pictures::Range& range = ranges_.at(static_cast<std::size_t>(quantity));
        range = joined(range, finder.range());
    }
    look_.range = ranges_.at(static_cast<std::size_t>(look_.quantity));
    scene_.show(snapshot_, look_);
    overlay_.set_caption(scenario_.name + ", frame " + std::to_string(frame()), numbers_of(snapshot_.record));
    overlay_.set_color_bar(look_.quantity, look_.range, look_.state == pictures::Look::State::particles);
    for (pictures::FrameChart* chart : {&impact_, &wall_}) {
        chart->show(records_, scenario_.growth.warm_up_frames, frame(), 0);
    }
    changed_ = true;
}

void Window::place_charts()
{
    const int* const size = window_->GetSize();
    const double width = (1 - scene_part) * size[0];
    impact_.place(0, 0.5 * size[1], width, 0.49 * size[1]);
    wall_.place(0, 0, width, 0.49 * size[1]);
}

std::string Window::note() const
{
    const Worker::Status status = worker_.status();
    std::string state = status.running ? "running" : "paused";
    if (!status.error.empty()) {
        state = "the simulation failed; the terminal says why";
    } else if (status.done) {
        state = "at the last frame, " + std::to_string(last_);
    }
    return state + "\n" + (help_ ? help_text : key_text);
}

} // namespace aneurysm::app
