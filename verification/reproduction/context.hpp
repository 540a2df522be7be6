// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/reproduction/run_store.hpp"
#include "verification/reproduction/section.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace aneurysm::reproduction
{

/// What an item of the reproduction works with.
struct Reproduction {
    RunStore& runs;
    nlohmann::json paper;      ///< data/paper.json: the paper's numbers
    std::filesystem::path out; ///< of all items
    int seeds = 0;             ///< members of an ensemble
    int first_seed = 1;

    /// The folder of an item, made when it is asked for.
    std::filesystem::path folder(const std::string& id) const;
    /// Tables as CSV and the rest as JSON, in the item's folder.
    void write(const Section& section) const;
};

/// One line or one set of points of a plot.
struct PlotSeries {
    std::string name;
    std::vector<double> x;
    std::vector<double> y;
    std::string style = "line"; ///< line, thin, points, dots
    int color = 0;              ///< number in the palette

    void add(double at, double value)
    {
        x.push_back(at);
        y.push_back(value);
    }
};
struct PlotPanel {
    std::string title;
    std::string x_label;
    std::string y_label;
    std::vector<PlotSeries> series{};
    bool log_y = false;
};

/// Draws panels side by side, `columns` in a row, with matplotlib.
/// \throws Error when python3 or matplotlib are missing
Picture plot(const std::filesystem::path& file, const std::string& caption, std::size_t columns,
             const std::vector<PlotPanel>& panels);

/// Calls `aneurysm render` with these words; its pictures are drawn with VTK.
/// \throws Error when it fails or isn't built
void render(const std::vector<std::string>& words);

/// data/NAME, JSON. \throws InputError
nlohmann::json read_data(const std::string& name);

/// With other values, and a name of its own. `where`: what has the changes, for the message.
/// \throws InputError
Scenario changed(const Scenario& scenario, const nlohmann::json& changes, const std::string& name,
                 const std::string& where);
/// A run for which nothing ruptures: Y is out of reach. What the wall would have done follows afterwards.
Scenario unbreakable(Scenario scenario);
/// Another member of the ensemble, with a name of its own.
Scenario with_seed(Scenario scenario, int seed);

} // namespace aneurysm::reproduction
