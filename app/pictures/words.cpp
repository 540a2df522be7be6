// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/words.hpp"

#include "common/error.hpp"

#include <sstream>

namespace aneurysm::app
{

namespace
{

constexpr int least = 64;
constexpr int most = 4096; // twice as many are drawn; OpenGL's textures end at 8192

std::optional<Size> size_of(const std::string& word)
{
    const auto good = [](int n) { return n >= least && n <= most && n % 2 == 0; };
    std::istringstream text(word);
    Size size;
    char cross = 0;
    text >> size.width >> cross >> size.height;
    const bool whole = text && text.eof() && cross == 'x';
    return whole && good(size.width) && good(size.height) ? std::optional(size) : std::nullopt;
}

} // namespace

CLI::Option* add_size(CLI::App& app, std::optional<Size>& size, const std::string& help)
{
    const auto check = [](const std::string& word) {
        return size_of(word) ? std::string()
                             : "no size (" + word + "), needed: WIDTHxHEIGHT, even numbers from " +
                                   std::to_string(least) + " to " + std::to_string(most);
    };
    return app
        .add_option_function<std::string>(
            "--size", [&size](const std::string& word) { size = size_of(word); }, help)
        ->check(CLI::Validator(check, "WIDTHxHEIGHT"));
}

void require_artery(const std::string& where, const Scenario& scenario)
{
    if (scenario.domain.form != DomainForm::artery) {
        throw InputError(where + ": domain.form", "scenario " + scenario.name + " has no artery to show",
                         "needed: artery");
    }
}

} // namespace aneurysm::app
