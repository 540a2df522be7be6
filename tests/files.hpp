// SPDX-License-Identifier: Apache-2.0
// What the tests of files share.
#pragma once

#include "common/file.hpp"
#include "common/scenario/shipped.hpp"
#include "output/columns.hpp"
#include "tests/support.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>

namespace aneurysm::test
{

namespace fs = std::filesystem;
using output::visit_aneurysm;
using output::visit_ledger;
using output::visit_record;

/// A directory of its own for each test, gone afterwards.
struct Scratch {
    Scratch() : path(fs::temp_directory_path() / ("aneurysm_" + std::to_string(std::random_device{}())))
    {
        fs::create_directory(path);
    }
    ~Scratch() { fs::remove_all(path); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    fs::path path;
};

inline Scenario scenario()
{
    return shipped_scenario("quick");
}

inline void write_text(const fs::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
}

/// Any bits that make a number, the smallest and the negative zero included.
class Numbers
{
public:
    double next()
    {
        constexpr std::array special{-0.0, 5e-324, 1.7976931348623157e308, 0.1, -1.0 / 3};
        if (count_++ % 7 == 0) {
            return special.at(count_ % special.size());
        }
        double x = std::numeric_limits<double>::quiet_NaN();
        while (!std::isfinite(x)) {
            x = std::bit_cast<double>(engine_());
        }
        return x;
    }
    std::int64_t integer() { return static_cast<std::int64_t>(engine_()); }
    Vec3 vector()
    {
        const double x = next();
        const double y = next();
        return {x, y, next()};
    }

private:
    std::mt19937_64 engine_{1};
    std::size_t count_ = 0;
};

inline void set(Numbers& numbers, double& x)
{
    x = numbers.next();
}
inline void set(Numbers& numbers, std::int64_t& x)
{
    x = numbers.integer();
}
inline void set(Numbers&, Phase& x)
{
    x = Phase::fully_developed;
}

/// \param count  of particles; by default as many as scenario() has
inline SimulationState any_state(std::int64_t frame, std::size_t count = 1500)
{
    Numbers numbers;
    SimulationState s;
    s.frame = frame;
    s.spacing = std::abs(numbers.next());
    s.particles.mass = std::abs(numbers.next());
    for (std::size_t i = 0; i < count; ++i) {
        s.particles.position.push_back(numbers.vector());
        s.particles.velocity.push_back(numbers.vector());
        s.particles.pressure.push_back(numbers.next());
        s.particles.kappa.push_back(numbers.next());
        s.particles.drift.push_back(numbers.next());
        s.particles.kind.push_back(static_cast<Kind>(i % 6));
    }
    visit_aneurysm(s.aneurysm, [&](std::string_view, auto& x) { set(numbers, x); });
    visit_ledger(s.ledger, [&](std::string_view, auto& x) { set(numbers, x); });
    s.outlet_velocity[0] = numbers.next();
    s.outlet_velocity[1] = numbers.next();
    return s;
}

inline FrameRecord any_record(std::int64_t frame)
{
    Numbers numbers;
    FrameRecord r;
    visit_record(r, [&](std::string_view, auto& x) { set(numbers, x); });
    r.frame = frame;
    return r;
}

} // namespace aneurysm::test
