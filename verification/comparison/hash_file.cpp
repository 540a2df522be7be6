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

void require(bool good, const std::filesystem::path& file, std::size_t line, const std::string& what,
             const std::string& advice)
{
    if (!good) {
        throw InputError(file.string() + ": line " + std::to_string(line), what, advice);
    }
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
    RecordedHashes result;
    bool has_precision = false;
    std::size_t number = 0;
    std::string line;
    while (std::getline(stream, line) && line.starts_with("# ")) {
        ++number;
        std::istringstream words(line.substr(2));
        std::string key;
        std::string value;
        words >> key >> value;
        if (key == "scenario") {
            require(value == scenario, file, number, "of another scenario (" + value + ")",
                    "needed: " + scenario);
            result.scenario = value;
        } else if (key == "scenario_hash") {
            result.scenario_hash = value;
        } else if (key == "precision") {
            require(value == name_of(precision), file, number, "of another precision (" + value + ")",
                    "needed: " + name_of(precision));
            result.precision = precision;
            has_precision = true;
        }
    }
    ++number;
    const std::string as_written = "needed: the file as it was written";
    require(!result.scenario.empty() && !result.scenario_hash.empty() && has_precision, file, number,
            "no scenario, scenario_hash or precision above", as_written);
    require(line == header(), file, number, "other columns than this version hashes",
            "record the hashes again");
    while (std::getline(stream, line)) {
        ++number;
        std::vector<std::string> cells = split(line);
        const std::int64_t frame = cells.empty() ? -1 : frame_of(cells[0]);
        require(frame >= 0 && cells.size() == hash_columns().size() + 1, file, number, "unreadable",
                as_written);
        result.frames[frame] = {cells.begin() + 1, cells.end()};
    }
    return result;
}

} // namespace aneurysm::comparison
