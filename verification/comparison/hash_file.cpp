// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/hash_file.hpp"

#include "common/error.hpp"
#include "common/file.hpp"
#include "common/text.hpp"
#include "output/build_info.hpp"
#include "output/frames.hpp"

#include <algorithm>
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

namespace
{

/// The lines of a file of hashes, one after the other.
class Lines
{
public:
    explicit Lines(const std::filesystem::path& file) : file_(file.string()), stream_(read_text(file)) {}

    /// \return whether there was one more \throws InputError when it is cut short
    bool next()
    {
        if (!std::getline(stream_, line)) {
            return false;
        }
        ++number_;
        require(!stream_.eof(), "cut short");
        return true;
    }
    /// What stands behind "# key ".
    std::string title(const std::string& key)
    {
        const std::string start = "# " + key + " ";
        const bool is_there = next();
        require(is_there && line.starts_with(start) && line.size() > start.size(),
                "no " + key + " (" + excerpt(line) + ")");
        return line.substr(start.size());
    }
    /// \throws InputError at this line
    void require(bool good, const std::string& what,
                 const std::string& advice = "needed: the file as it was written") const
    {
        if (!good) {
            throw InputError(file_ + ": line " + std::to_string(number_), what, advice);
        }
    }

    std::string line;

private:
    std::string file_;
    std::istringstream stream_;
    std::size_t number_ = 0;
};

bool is_hash(const std::string& cell)
{
    return cell.size() == 16 && cell.find_first_not_of("0123456789abcdef") == std::string::npos;
}

} // namespace

RecordedHashes read_hashes(const std::filesystem::path& file, const std::string& scenario,
                           Precision precision)
{
    Lines lines(file);
    const std::string its_scenario = lines.title("scenario");
    lines.require(its_scenario == scenario, "of another scenario (" + excerpt(its_scenario) + ")",
                  "needed: " + scenario);
    const std::string scenario_hash = lines.title("scenario_hash");
    lines.require(is_hash(scenario_hash), "no hash (" + excerpt(scenario_hash) + ")");
    const std::string its_precision = lines.title("precision");
    lines.require(its_precision == name_of(precision),
                  "of another precision (" + excerpt(its_precision) + ")",
                  std::string("needed: ") + name_of(precision));
    lines.title("version");
    lines.require(lines.next() && lines.line == header(), "other columns than this version hashes",
                  "record the hashes again");
    RecordedHashes result{scenario, scenario_hash, precision, {}};
    for (std::int64_t last = 0; lines.next();) {
        const std::vector<std::string> cells = split(lines.line);
        const std::int64_t frame = cells.empty() ? -1 : frame_of(cells[0]);
        const std::vector<std::string> hashes(cells.begin() + (cells.empty() ? 0 : 1), cells.end());
        lines.require(frame > last && hashes.size() == hash_columns().size() &&
                          std::ranges::all_of(hashes, is_hash) &&
                          lines.line == std::to_string(frame) + "," + joined(hashes, ","),
                      "unreadable, or a frame that isn't after the one before (" + excerpt(lines.line) + ")");
        result.frames[frame] = hashes;
        last = frame;
    }
    return result;
}

} // namespace aneurysm::comparison
