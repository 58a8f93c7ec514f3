// ask.* and job.*: all questions, answered at once or as background jobs.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/progress_parts.h"
#include "questions/question.h"
#include "server/methods/method_table.h"

namespace thenar::internal {
namespace {

constexpr std::size_t kMaxPosturesAtOnce = 200;  // largest grid that is answered at once

/// @throws InputError for a grid of postures that would keep other clients waiting
void require_short(const Json& params) {
  double postures = 1;
  for (const char* const key : {"vary_deg", "vary_rad"})
    if (params.contains(key))
      for (const Json& range : params[key])
        postures *= 1 + (range["to"].get<double>() - range["from"].get<double>()) /
                            range["step"].get<double>();
  require(!(postures > kMaxPosturesAtOnce),
          "wanted at most {} postures at once, got {:.0f}: ask by job.start", kMaxPosturesAtOnce,
          postures);
}

OrderedJson reply_of(const Answer& answer) {
  OrderedJson reply = answer.json(UnitSystem::kSi);
  if (answer.refusal.empty()) return reply;
  // A list has the refusal in each of its objects.
  if (reply.is_object()) reply["refusal"] = answer.refusal;
  if (reply.is_array())
    for (OrderedJson& each : reply) each["refusal"] = answer.refusal;
  return reply;
}

RpcMethod ask_method(const Question& question) {
  const auto handler = [&question](Session& session, const Json& params, const Progress& progress) {
    require_short(params);
    const Answer answer = question.ask(params, session.folders().data, progress);
    if (answer.outcome.status == Status::kStopped) throw Stopped("stopped");
    return reply_of(answer);
  };
  return {"ask." + question.name,
          question.description,
          schema_of(question.params, ParamScope::kAnywhere),
          fmt::format("the same as `thenar {} --json`, in SI units; each key ends in its unit",
                      question.command),
          question.example,
          handler};
}

OrderedJson state_json(const JobState& state) {
  return {{"job", state.id},
          {"question", state.question},
          {"state", name_of(state.stage)},
          {"fraction", number_or_null(state.fraction)},
          {"text", state.text},
          {"seconds", state.seconds}};
}

OrderedJson start_job(Session& session, const Json& params, const Progress& /*progress*/) {
  const Question& question = question_named(params["question"].get<std::string>());
  // Refuse parameters that only local programs may set.
  const Json& request = params["request"];
  for (const auto& [key, value] : request.items())
    for (const Param& param : question.params)
      require_field("request", param.scope == ParamScope::kAnywhere || param.member.name != key,
                    "'{}' is for programs of the server's own machine", key);
  // Check the request before it is queued.
  (void)request_in_si(question.params, request);
  return {{"job", session.jobs().start(question, request, session.folders().data)}};
}

Schema job_schema() {
  return object_schema({{"job", integer_schema(1, 1e9), "The id that job.start returned.", true}});
}

int job_param(const Json& params) { return params["job"].get<int>(); }

}  // namespace

void add_question_methods(MethodTable& table) {
  for (const Question& question : questions())
    if (question.pace == QuestionPace::kAtOnce) table.add(ask_method(question));
  table.add({"job.start",
             "Runs a question in the background, while the session continues; it reads files, "
             "never the live world.",
             object_schema({{"question", word_schema(question_names()), "Which.", true},
                            {"request", any_object_schema(),
                             "Its parameters, as of ask.* and of files of requests; `thenar ask "
                             "QUESTION` prints them.",
                             true}}),
             "job: its id", R"({"question": "tip_force", "request": {"subject": "synek2019_middle",
                 "tension_N": {"FDP": 10}}})",
             start_job});
  table.add({"job.state", "Reports the progress of a job.", job_schema(),
             "job, question, state (waiting, running, done, stopped, failed), fraction, text (what "
             "it does, or why it failed), seconds",
             R"({"job": 1})", [](Session& session, const Json& params, const Progress&) {
               return state_json(session.jobs().state(job_param(params)));
             }});
  table.add({"job.list", "Reports the progress of all jobs.", object_schema({}),
             "jobs: a list of what job.state returns", "{}",
             [](Session& session, const Json&, const Progress&) {
               OrderedJson list = OrderedJson::array();
               for (const JobState& state : session.jobs().states())
                 list.push_back(state_json(state));
               return OrderedJson{{"jobs", list}};
             }});
  table.add({"job.stop", "Asks a job to stop and keep its best so far.", job_schema(),
             "asked: false if it had already ended", R"({"job": 1})",
             [](Session& session, const Json& params, const Progress&) {
               return OrderedJson{{"asked", session.jobs().stop(job_param(params))}};
             }});
  table.add({"job.result", "Gives the answer of a job that has ended.", job_schema(),
             "request as it was answered, status, warnings; answer: as `--json` of the command, in "
             "SI, the unit in each key; refusal: why it must not be used, if so",
             R"({"job": 1})", [](Session& session, const Json& params, const Progress&) {
               return session.jobs().result(job_param(params));
             }});
}

}  // namespace thenar::internal
