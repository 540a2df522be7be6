// SPDX-License-Identifier: Apache-2.0
#include "common/scenario/json.hpp"

#include <algorithm>
#include <vector>

namespace aneurysm::fields
{
namespace
{

/// Follows the parser through the text: where it is, and which keys each open object has had.
class KeyWatch
{
public:
    explicit KeyWatch(const std::string& origin) : origin_(origin) {}

    bool operator()(int, Json::parse_event_t event, const Json& parsed)
    {
        if (event == Json::parse_event_t::object_start) {
            open_.emplace_back();
        } else if (event == Json::parse_event_t::object_end) {
            open_.pop_back();
        } else if (event == Json::parse_event_t::key) {
            const auto key = parsed.get<std::string>();
            open_.back().last = key;
            if (!open_.back().keys.insert(key).second) {
                throw InputError(place(origin_, path()),
                                 "key appears twice in its object (" + shown(parsed) + ")",
                                 "allowed: each key once");
            }
        }
        return true;
    }

    std::string path() const
    {
        std::string text;
        for (const Object& object : open_) {
            text += (text.empty() || object.last.empty() ? "" : ".") + object.last;
        }
        return text.empty() ? "(top)" : text;
    }

private:
    struct Object {
        std::set<std::string> keys;
        std::string last;
    };
    const std::string& origin_;
    std::vector<Object> open_;
};

/// The library's message without its own numbering, "parse error at line 3, column 5: ...", and without the
/// text that it quotes where that isn't UTF-8.
std::string reason_of(const nlohmann::json::exception& error)
{
    const std::string text = error.what();
    const auto start = text.find("] ");
    const auto quoted = std::min(text.find("; last read"), text.size());
    const bool printable = text.find("ill-formed UTF-8") == std::string::npos;
    const auto from = start == std::string::npos ? 0 : start + 2;
    return text.substr(from, printable ? std::string::npos : quoted - from);
}

} // namespace

Json parse_strictly(const std::string& text, const std::string& origin)
{
    KeyWatch watch(origin);
    try {
        return Json::parse(text, std::ref(watch));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(place(origin, watch.path()), "malformed JSON (" + reason_of(error) + ")",
                         "allowed: JSON text as RFC 8259 defines it, with finite numbers");
    }
}

} // namespace aneurysm::fields
