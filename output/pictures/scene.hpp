// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "output/pictures/camera.hpp"
#include "output/pictures/coloring.hpp"
#include "output/pictures/wall_surface.hpp"
#include "output/vtk.hpp"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <optional>

namespace aneurysm::pictures
{

/// What a frame shows.
struct Snapshot {
    FrameRecord record;
    output::ShownParticles particles;
};

/// How it is shown.
struct Look {
    enum class State {
        particles, ///< spheres
        fluid,     ///< the blood's surface
    };
    State state = State::particles;
    Quantity quantity = Quantity::speed;
    Range range;
    bool wall = true;
    double wall_cells = 16; ///< of the wall's grid, in an artery radius
    double blood_cells = 3; ///< of the blood's grid, in a particle spacing
};

/// Wall and blood of one artery in a renderer.
class Scene
{
public:
    /// `spacing`: of the particles [m]. \pre the vessel is an artery
    Scene(const Scenario& scenario, const Vessel& vessel, double spacing);

    vtkRenderer& renderer() { return *renderer_; }
    const Vessel& vessel() const { return vessel_; }

    void show(const Snapshot& snapshot, const Look& look);

private:
    WallShape shape_of(const FrameRecord& record) const;
    void show_wall(const WallShape& shape, const Look& look);
    void show_particles(const output::ShownParticles& particles, const Look& look);
    void show_fluid(const output::ShownParticles& particles, const WallShape& shape, const Look& look);

    Vessel vessel_;
    double spacing_;
    double breach_radius_;
    std::optional<WallShape> shown_wall_; ///< what wall_ holds
    vtkSmartPointer<vtkRenderer> renderer_;
    vtkSmartPointer<vtkActor> particles_;
    vtkSmartPointer<vtkActor> fluid_;
    vtkSmartPointer<vtkActor> wall_;
    vtkSmartPointer<vtkActor> rim_;
    vtkSmartPointer<vtkActor> ends_;
};

} // namespace aneurysm::pictures
