// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/hash_file.hpp"

#include "common/error.hpp"
#include "common/file.hpp"
#include "common/text.hpp"
#include "output/build_info.hpp"
#include "output/frames.hpp"

#include <charconv>
#include <sstream>

namespace aneurysm::comparison
{
namespace
{

std::vector<std::string> split(const std::string& line)
{
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) {
        cells.push_back(cell);
    }
    return cells;
}

std::string header()
{
    return output::hashes_header() + ",state";
}

std::int64_t frame_of(const std::string& cell)
{
    std::int64_t frame = -1;
    const auto end = std::from_chars(cell.data(), cell.data() + cell.size(), frame);
    return end.ec == std::errc() && end.ptr == cell.data() + cell.size() ? frame : -1;
}

} // namespace

std::vector<std::string> hash_columns()
{
    std::vector<std::string> columns = split(header());
    columns.erase(columns.begin());
    return columns;
}

std::vector<std::string> hashes_of(const SimulationState& state)
{
    std::vector<std::string> hashes = split(output::hashes_row(state) + "," + output::state_hash(state));
    hashes.erase(hashes.begin());
    return hashes;
}

std::vector<std::string> differing_columns(const std::vector<std::string>& a,
                                           const std::vector<std::string>& b)
{
    const std::vector<std::string> columns = hash_columns();
    std::vector<std::string> names;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (a[k] != b[k]) {
            names.push_back(columns[k]);
        }
    }
    return names;
}

std::string recorded_as(const backends::BackendChoice& choice)
{
    return choice.backend == Backend::reference ? name_of(choice.backend) : name_of(choice.precision);
}

std::filesystem::path hash_file(const std::filesystem::path& scenario_file, const Scenario& scenario,
                                const backends::BackendChoice& choice)
{
    return std::filesystem::absolute(scenario_file).parent_path().parent_path() / "hashes" /
           (scenario.name + "." + recorded_as(choice) + ".csv");
}

std::string to_csv(const RecordedHashes& hashes)
{
    std::ostringstream text;
    text << "# scenario " << hashes.scenario << "\n"
         << "# scenario_hash " << hashes.scenario_hash << "\n"
         << "# precision " << name_of(hashes.precision) << "\n"
         << "# version " << output::build_info().version << "\n"
         << header() << "\n";
    for (const auto& [frame, row] : hashes.frames) {
        text << frame << "," << joined(row, ",") << "\n";
    }
    return text.str();
}

RecordedHashes read_hashes(const std::filesystem::path& file, const std::string& scenario,
                           Precision precision)
{
    std::istringstream stream(read_text(file));
    std::size_t number = 1;
    const auto require = [&](bool good, const std::string& what,
                             const std::string& advice = "needed: the file as it was written") {
        if (!good) {
            throw InputError(file.string() + ": line " + std::to_string(number), what, advice);
        }
    };
    std::map<std::string, std::string> title;
    std::string line;
    for (; std::getline(stream, line) && line.starts_with("# "); ++number) {
        std::istringstream words(line.substr(2));
        std::string key;
        std::string value;
        words >> key >> value;
        require(key != "scenario" || value == scenario, "of another scenario (" + value + ")",
                "needed: " + scenario);
        require(key != "precision" || value == name_of(precision), "of another precision (" + value + ")",
                "needed: " + name_of(precision));
        title[key] = value;
    }
    require(!title["scenario"].empty() && !title["scenario_hash"].empty() && !title["precision"].empty(),
            "no scenario, scenario_hash or precision above");
    require(line == header(), "other columns than this version hashes", "record the hashes again");
    RecordedHashes result{scenario, title["scenario_hash"], precision, {}};
    while (std::getline(stream, line)) {
        ++number;
        std::vector<std::string> cells = split(line);
        const std::int64_t frame = cells.empty() ? -1 : frame_of(cells[0]);
        require(frame >= 0 && cells.size() == hash_columns().size() + 1, "unreadable");
        result.frames[frame] = {cells.begin() + 1, cells.end()};
    }
    return result;
}

} // namespace aneurysm::comparison
