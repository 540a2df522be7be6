// SPDX-License-Identifier: Apache-2.0
#include "output/json.hpp"
#include "output/provenance.hpp"
#include "verification/suite/report.hpp"

namespace aneurysm::suite
{
namespace
{

output::Json to_json(const Quantity& q)
{
    const Quantity::Worst& w = q.worst();
    return {{"name", q.name()},
            {"source", name_of(q.source())},
            {"derivation", q.derivation()},
            {"compared", q.compared()},
            {"failed", q.failed()},
            {"passed", q.passed()},
            {"loose", q.loose()},
            {"worst",
             {{"where", w.where},
              {"value", output::json_number(w.value)},
              {"expected", output::json_number(w.expected)},
              {"measured", output::json_number(w.error)},
              {"allowed", output::json_number(w.allowed)},
              {"ratio", q.compared() > 0 ? output::json_number(w.ratio) : output::Json()}}}};
}

output::Json to_json(const Series& s)
{
    return {{"name", s.name},
            {"line", s.line},
            {"x", output::json_array(s.x, output::json_number)},
            {"y", output::json_array(s.y, output::json_number)}};
}

output::Json to_json(const Plot& p)
{
    return {{"title", p.title},
            {"x_label", p.x_label},
            {"y_label", p.y_label},
            {"log_x", p.log_x},
            {"log_y", p.log_y},
            {"series", output::json_array(p.series, [](const Series& s) { return to_json(s); })}};
}

output::Json to_json(const Check& c)
{
    return {{"id", c.id},       {"level", number_of(c.level)}, {"equations", c.equations},
            {"title", c.title}, {"oracles", c.oracles},        {"scope", name_of(c.scope)},
            {"quick", c.quick}};
}

output::Json to_json(const Accuracy& a)
{
    return {{"name", a.name},
            {"value", output::json_number(a.value)},
            {"asked", a.asked},
            {"met", a.met()},
            {"recorded", a.known ? output::json_number(a.known->value) : output::Json()},
            {"source", a.known ? a.known->source : ""}};
}

output::Json to_json(const CheckResult& r)
{
    output::Json json = to_json(*r.check);
    json["subject"] = r.subject;
    json["verdict"] = name_of(r.verdict);
    json["message"] = r.message;
    json["seconds"] = r.seconds;
    json["quantities"] = output::json_array(r.quantities, [](const Quantity& q) { return to_json(q); });
    json["accuracies"] = output::json_array(r.accuracies, [](const Accuracy& a) { return to_json(a); });
    json["notes"] = output::json_array(r.notes, [](const Note& n) {
        return output::Json{{"name", n.name}, {"value", output::json_number(n.value)}, {"remark", n.remark}};
    });
    json["plots"] = output::json_array(r.plots, [](const Plot& p) { return to_json(p); });
    return json;
}

output::Json to_json(const EquationSummary& e)
{
    return {{"id", e.equation->id},
            {"title", e.equation->title},
            {"reading", name_of(e.equation->status)},
            {"deviation", e.equation->deviation},
            {"in_runs", name_of(e.equation->use)},
            {"verdict", name_of(e.verdict)},
            {"remark", e.remark},
            {"checks", output::json_array(e.checks, [](const Check* c) { return c->id; })},
            {"evidence", output::json_array(e.checks, [](const Check* c) { return is_evidence(*c); })}};
}

output::Json to_json(const SuiteSubject& s)
{
    return {{"name", s.subject.name()},
            {"device", s.device},
            {"missing", s.missing},
            {"roundoff", s.subject.roundoff}};
}

} // namespace

std::string suite_json(const SuiteReport& report)
{
    const Tally all = tally(report.suite);
    output::Json json = output::provenance();
    json["report"] = "verification 1";
    json["date"] = report.date;
    json["machine"] = report.machine;
    json["threads"] = report.threads;
    json["selection"] = report.selection;
    json["command"] = report.command;
    json["seconds"] = report.suite.seconds;
    json["complete"] = report.suite.complete;
    json["passed"] = passed(report.suite);
    json["headline"] = headline(report.equations);
    json["holds"] = all.holds;
    json["fails"] = all.fails;
    json["not_run"] = all.not_run;
    json["limits"] = all.limits;
    json["compared"] = all.compared;
    json["largest_ratio"] = all.compared > 0 ? output::json_number(all.ratio) : output::Json();
    json["subjects"] =
        output::json_array(report.suite.subjects, [](const SuiteSubject& s) { return to_json(s); });
    json["equations"] =
        output::json_array(report.equations, [](const EquationSummary& e) { return to_json(e); });
    json["results"] =
        output::json_array(report.suite.results, [](const CheckResult& r) { return to_json(r); });
    return output::json_text(json);
}

} // namespace aneurysm::suite
