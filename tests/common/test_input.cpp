// SPDX-License-Identifier: Apache-2.0
// What comes from outside, in its one way in: numbers as typed, exceptions of the libraries, words for a shell.
#include "common/error.hpp"
#include "common/exception.hpp"
#include "common/number.hpp"
#include "common/parallel.hpp"
#include "common/text.hpp"

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <filesystem>
#include <limits>
#include <new>
#include <stdexcept>
#include <system_error>

using namespace aneurysm;

namespace
{

/// "where: what; advice", with a place that isn't empty.
bool has_form(const std::string& text)
{
    const auto where = text.find(": ");
    return where > 0 && where != std::string::npos && text.find("; ", where) != std::string::npos &&
           text.find('\n') == std::string::npos;
}

} // namespace

BOOST_AUTO_TEST_CASE(whole_numbers_are_decimal_and_exact)
{
    const std::initializer_list<std::pair<const char*, std::int64_t>> good{
        {"0", 0},
        {"10", 10},
        {"010", 10},
        {"0000010", 10},
        {"+7", 7},
        {"-7", -7},
        {"1e3", 1000},
        {"3E3", 3000},
        {"20.0", 20},
        {"20.", 20},
        {"0.5e1", 5},
        {".5e1", 5},
        {"100e-2", 1},
        {"0e999", 0},
        {"0.000", 0},
        {"1e+2", 100},
        {"-0", 0},
        {"9223372036854775807", 9223372036854775807},
        {"9007199254740993", 9007199254740993}, // no double
        {"-9223372036854775808", std::numeric_limits<std::int64_t>::min()}};
    for (const auto& [text, number] : good) {
        BOOST_TEST(whole_number(text).value_or(-1) == number, text);
    }
    for (const char* text : {"",      "+",
                             "-",     ".",
                             "e3",    "1e",
                             "1e+",   "1.5",
                             "1e-1",  "0x10",
                             "0b1",   "1_0",
                             " 1",    "1 ",
                             "1,5",   "+-1",
                             "--1",   "nan",
                             "inf",   "9223372036854775808",
                             "1e19",  "1e999999999999",
                             "1.2.3", "\xd9\xa3"}) {
        BOOST_TEST(!whole_number(text), text);
    }
}

BOOST_AUTO_TEST_CASE(numbers_are_finite)
{
    BOOST_TEST(finite_number("0.5").value_or(0) == 0.5);
    BOOST_TEST(finite_number("+1e3").value_or(0) == 1000);
    for (const char* text : {"", "nan", "inf", "-inf", "1e999", "0x1p3", "1,5", " 1", "1s", "+-1"}) {
        BOOST_TEST(!finite_number(text), text);
    }
}

BOOST_AUTO_TEST_CASE(every_exception_says_where_what_and_what_to_do)
{
    const auto code = [](std::errc reason) { return std::make_error_code(reason); };
    const std::filesystem::filesystem_error long_name("status", "runs", code(std::errc::filename_too_long));
    const std::filesystem::filesystem_error full("copy", "runs", code(std::errc::no_space_on_device));
    const std::system_error threads(code(std::errc::resource_unavailable_try_again));
    const std::bad_alloc memory;
    const std::length_error length("vector");
    const std::runtime_error other("odd");
    for (const std::exception* error : std::initializer_list<const std::exception*>{
             &long_name, &full, &threads, &memory, &length, &other}) {
        BOOST_TEST(has_form(text_of(*error)), text_of(*error));
    }
    BOOST_TEST(text_of(long_name).starts_with("runs: "));
    BOOST_TEST(text_of(threads).starts_with("threads: "));
    BOOST_TEST(text_of(memory).starts_with("memory: "));
    BOOST_TEST(is_bad_input(long_name));
    BOOST_TEST(!is_bad_input(full));
    BOOST_TEST(!is_bad_input(memory));
    BOOST_TEST(is_bad_input(InputError("a", "b", "c")));
    BOOST_TEST(!is_bad_input(SimulationError("a", "b", "c")));
    BOOST_TEST(text_of(InputError("a", "b", "c")) == "a: b; c");
}

BOOST_AUTO_TEST_CASE(words_are_quoted_for_a_shell)
{
    BOOST_TEST(shell_word("results/a-1.json") == "results/a-1.json");
    BOOST_TEST(shell_word("my run") == "'my run'");
    BOOST_TEST(shell_word("it's") == "'it'\\''s'");
    BOOST_TEST(shell_word("") == "''");
    BOOST_TEST(shell_word("$x") == "'$x'");
}

BOOST_AUTO_TEST_CASE(work_is_shared_by_as_many_threads_as_there_are)
{
    BOOST_TEST(paying_threads() >= 1);
    BOOST_TEST(thread_count(3) == 3);
    BOOST_TEST(thread_count(0) == paying_threads());
    BOOST_TEST(startable_threads(1) == 1);
    const int many = startable_threads(1'000'000);
    BOOST_TEST(many >= 1);
    BOOST_TEST(many < 100'000);
    std::atomic<int> done = 0;
    in_parallel(1000, 1'000'000, [&done](std::size_t) { ++done; });
    BOOST_TEST(done == 1000);
    in_parallel(0, 5, [&done](std::size_t) { ++done; });
    BOOST_TEST(done == 1000);
    BOOST_CHECK_THROW(in_parallel(5, 2, [](std::size_t) { throw InputError("a", "b", "c"); }), InputError);
}
