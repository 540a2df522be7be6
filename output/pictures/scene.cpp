// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/scene.hpp"

#include "output/pictures/blood_surface.hpp"

#include <vtkDoubleArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTubeFilter.h>

namespace aneurysm::pictures
{
namespace
{

/// A light that goes with the camera; the place is in the camera's own directions.
void add_light(vtkRenderer& renderer, const Vec3& from, double intensity)
{
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(from.x, from.y, from.z);
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(intensity);
    renderer.AddLight(light);
}

vtkSmartPointer<vtkRenderer> make_renderer()
{
    auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetBackground(1, 1, 1);
    renderer->SetBackground2(0.86, 0.89, 0.93);
    renderer->GradientBackgroundOn();
    renderer->AutomaticLightCreationOff();
    add_light(*renderer, {-0.6, 0.8, 1}, 0.75);
    add_light(*renderer, {0.9, 0.1, 0.7}, 0.3);
    add_light(*renderer, {0, -0.6, 0.8}, 0.15);
    renderer->SetUseDepthPeeling(true);
    renderer->SetMaximumNumberOfPeels(6);
    renderer->SetOcclusionRatio(0);
    return renderer;
}

vtkSmartPointer<vtkActor> make_actor(vtkMapper* mapper, const Vec3& color)
{
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    vtkProperty& property = *actor->GetProperty();
    property.SetColor(color.x, color.y, color.z);
    property.SetAmbient(0.18);
    property.SetDiffuse(0.85);
    return actor;
}

void set_specular(vtkActor& actor, double strength, double power)
{
    actor.GetProperty()->SetSpecular(strength);
    actor.GetProperty()->SetSpecularPower(power);
}

/// Glass: clear where it is seen from the front, denser where it is seen edge-on.
void make_glass(vtkActor& actor)
{
    actor.GetProperty()->SetOpacity(0.3);
    actor.ForceTranslucentOn();
    actor.GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Light::Impl", true,
        "//VTK::Light::Impl\n"
        "  float edge = 1.0 - abs(normalVCVSOutput.z);\n"
        "  gl_FragData[0].a = 0.10 + 0.62 * edge * edge;\n",
        false);
}

/// Round tubes along lines.
vtkSmartPointer<vtkActor> make_lines(const Vec3& color)
{
    const vtkNew<vtkPolyDataMapper> mapper;
    const vtkSmartPointer<vtkActor> actor = make_actor(mapper, color);
    set_specular(*actor, 0.3, 20);
    return actor;
}

void set_lines(vtkActor& actor, vtkPolyData* lines, double radius)
{
    vtkNew<vtkTubeFilter> tube;
    tube->SetInputData(lines);
    tube->SetRadius(radius);
    tube->SetNumberOfSides(12);
    tube->CappingOn();
    tube->Update();
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(tube->GetOutput());
}

vtkSmartPointer<vtkActor> make_spheres(double radius)
{
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetRadius(static_cast<float>(radius));
    mapper->SetColorModeToMapScalars();
    mapper->UseLookupTableScalarRangeOn();
    const vtkSmartPointer<vtkActor> actor = make_actor(mapper, {1, 1, 1});
    set_specular(*actor, 0.25, 30);
    return actor;
}

} // namespace

Scene::Scene(const Scenario& scenario, const Vessel& vessel, double spacing)
    : vessel_(vessel), spacing_(spacing),
      breach_radius_(scenario.rupture.breach_radius_radii * scenario.vessel.radius_m),
      renderer_(make_renderer()), particles_(make_spheres(0.5 * spacing))
{
    const vtkNew<vtkPolyDataMapper> blood;
    fluid_ = make_actor(blood, {0.68, 0.03, 0.05});
    set_specular(*fluid_, 0.55, 45);
    const vtkNew<vtkPolyDataMapper> glass;
    wall_ = make_actor(glass, {0.86, 0.62, 0.58});
    set_specular(*wall_, 0.5, 60);
    make_glass(*wall_);
    rim_ = make_lines({0.95, 0.55, 0.05});
    ends_ = make_lines({0.62, 0.45, 0.43});
    for (const auto& actor : {particles_, fluid_, rim_, ends_, wall_}) {
        renderer_->AddActor(actor);
    }
}

WallShape Scene::shape_of(const FrameRecord& record) const
{
    return output::wall_shape(vessel_, record.radius + record.displacement, record.phase == Phase::ruptured,
                              breach_radius_);
}

void Scene::show(const Snapshot& snapshot, const Look& look)
{
    const WallShape shape = shape_of(snapshot.record);
    for (const auto& actor : {wall_, rim_, ends_}) {
        actor->SetVisibility(look.wall);
    }
    if (look.wall) {
        show_wall(shape, look);
    }
    const bool fluid = look.state == Look::State::fluid;
    fluid_->SetVisibility(fluid);
    particles_->SetVisibility(!fluid);
    if (fluid) {
        show_fluid(snapshot.particles, shape, look);
    } else {
        show_particles(snapshot.particles, look);
    }
}

void Scene::show_wall(const WallShape& shape, const Look& look)
{
    rim_->SetVisibility(shape.breach.has_value());
    if (shown_wall_ && shown_wall_->radius == shape.radius &&
        shown_wall_->breach.has_value() == shape.breach.has_value()) {
        return; // a ruptured sac stands still
    }
    shown_wall_ = shape;
    const double r_0 = vessel_.openings()[0].radius;
    const WallSurface surface = wall_surface(vessel_, shape, r_0 / look.wall_cells);
    vtkPolyDataMapper::SafeDownCast(wall_->GetMapper())->SetInputData(surface.wall);
    set_lines(*rim_, surface.rim, 0.045 * r_0);
    set_lines(*ends_, surface.ends, 0.025 * r_0);
}

void Scene::show_particles(const output::ShownParticles& particles, const Look& look)
{
    const std::vector<double> all = shown_values(particles, look.quantity);
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> vertices;
    vtkNew<vtkDoubleArray> values;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.is_blood(i)) {
            const Vec3& x = particles.position[i];
            const vtkIdType n = points->InsertNextPoint(x.x, x.y, x.z);
            vertices->InsertNextCell(1, &n);
            values->InsertNextValue(all[i]);
        }
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(vertices);
    data->GetPointData()->SetScalars(values);
    auto& mapper = *vtkOpenGLSphereMapper::SafeDownCast(particles_->GetMapper());
    mapper.SetInputData(data);
    mapper.SetLookupTable(colors_of(look.quantity, look.range));
}

void Scene::show_fluid(const output::ShownParticles& particles, const WallShape& shape, const Look& look)
{
    const Lumen lumen{vessel_, shape, 0.15 * spacing_, 0.3 * spacing_};
    const auto surface = blood_surface(particles, spacing_, &lumen, spacing_ / look.blood_cells);
    vtkPolyDataMapper::SafeDownCast(fluid_->GetMapper())->SetInputData(surface);
}

} // namespace aneurysm::pictures
