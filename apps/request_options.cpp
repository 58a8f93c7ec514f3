#include "apps/request_options.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/kind_commands.h"
#include "apps/options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

using Kind = Schema::Kind;

constexpr double kMaxWhole = 1e15;  // Largest whole number that is typed; all below are doubles

/// A plain decimal number. @param what  how messages call it: "an angle [deg]"
/// @throws InputError if the whole text is not one finite number.
double parse_number(const std::string& text, const std::string& what) {
  std::size_t read = 0;
  double value = 0;
  try {
    value = std::stod(text, &read);
  } catch (const std::exception&) {
    read = 0;  // not a number, or out of range
  }
  const bool hexadecimal = text.find_first_of("xX") != std::string::npos;
  require(read > 0 && read == text.size() && std::isfinite(value) && !hexadecimal,
          "wanted {}, got '{}'", what, text);
  return value;
}

/// A number that may be infinite, as "free" and "inf" are.
Json typed_number(const Schema& schema, const std::string& text, const std::string& what) {
  if (schema.accepts_infinity) {
    if (text == "free" || text == "inf" || text == "-inf") return text == "-inf" ? text : "inf";
    if (text == "zero") return 0.0;
  }
  const double value = parse_number(text, what);
  if (schema.kind != Kind::kInteger) return value;
  require(value == std::floor(value) && std::abs(value) < kMaxWhole, "wanted {}, got '{}'", what,
          text);
  return static_cast<long>(value);
}

/// "a length [mm]": how messages call a value of the schema.
std::string what_is(const Schema& schema) {
  const std::string unit = schema.unit.empty() ? "" : fmt::format(" [{}]", schema.unit);
  return (schema.kind == Kind::kInteger ? "a whole number" : "a number") + unit;
}

/// NAME=value pairs, or values alone where those will do.
/// @param form  of a pair: "MUSCLE=newton"
Json typed_map(const Schema& schema, const std::string& form,
               const std::vector<std::string>& texts) {
  // A list of plain values is told from pairs by its first entry.
  const bool named =
      !schema.accepts_list || texts.empty() || texts[0].find('=') != std::string::npos;
  Json json = named ? Json::object() : Json::array();
  for (const std::string& text : texts) {
    const std::size_t sign = text.find('=');
    if (!named) {
      json.push_back(typed_number(*schema.element, text, what_is(*schema.element)));
      continue;
    }
    // Each name once, with a number in the unit of the option.
    require(sign != std::string::npos && sign > 0, "wanted {}, got '{}'", form, text);
    const std::string name = text.substr(0, sign);
    require(!json.contains(name), "'{}' is given twice", name);
    json[name] = typed_number(*schema.element, text.substr(sign + 1),
                              fmt::format("{} for '{}'", form, name));
  }
  return json;
}

/// "NAME=from:to:step": how an object is typed, a value for each member behind the first.
std::string range_form(const Schema& each) {
  std::string form = "NAME=";
  for (std::size_t i = 1; i < each.members.size(); ++i)
    form += (i == 1 ? "" : ":") + each.members[i].name;
  return form;
}

Json typed_ranges(const Schema& each, const std::vector<std::string>& texts) {
  const std::string form = range_form(each);
  Json list = Json::array();
  for (const std::string& text : texts) {
    // Read NAME=FROM:TO:STEP, or with a count in place of the step, part by part.
    std::size_t from = text.find('=');
    require(from != std::string::npos && from > 0, "wanted {}, got '{}'", form, text);
    Json range{{each.members[0].name, text.substr(0, from)}};
    for (std::size_t i = 1; i < each.members.size(); ++i) {
      require(from != std::string::npos, "wanted {}, got '{}'", form, text);
      const std::size_t to = text.find(':', from + 1);
      const SchemaMember& part = each.members[i];
      const bool counts = part.schema.kind == Kind::kInteger;
      range[part.name] = typed_number(
          part.schema, text.substr(from + 1, to - from - 1),
          counts ? "a whole number of values" : fmt::format("a number for '{}'", part.name));
      from = to;
    }
    // Nothing may follow the last part.
    require(from == std::string::npos, "wanted {}, got '{}'", form, text);
    list.push_back(std::move(range));
  }
  return list;
}

Json typed_list(const Schema& schema, const std::vector<std::string>& texts) {
  if (schema.element->kind == Kind::kObject) return typed_ranges(*schema.element, texts);
  Json list = Json::array();
  for (const std::string& text : texts) {
    if (schema.element->kind == Kind::kText)
      list.push_back(text);
    else
      list.push_back(typed_number(*schema.element, text, what_is(*schema.element)));
  }
  return list;
}

/// The default as the help shows it.
std::string shown_default(const Param& param) {
  const Json& usual = param.member.default_value;
  if (usual.is_null() || param.member.required) return "";
  if (usual.is_string()) return usual.get<std::string>();
  if (usual.is_number_float())
    return fmt::format("{:g}", usual.get<double>() * param.unit.numerator / param.unit.denominator);
  return json_text(usual, -1);
}

/// A sentence without its full stop.
std::string without_stop(std::string text) {
  if (!text.empty() && text.back() == '.') text.pop_back();
  return text;
}

/// Returns a help sentence, without its full stop, with the form of the argument and its unit.
std::string help_of(const Param& param, const Schema& schema) {
  std::string text = without_stop(param.member.description);
  const std::string& unit = schema.element ? schema.element->unit : schema.unit;
  if (!unit.empty()) text += fmt::format(" [{}]", unit);
  if (schema.words.empty()) return text;
  return fmt::format("{}: {}", fmt::join(schema.words, "|"), text);
}

/// Names of the options of a parameter, without dashes.
std::vector<std::string> option_names(const Param& param) {
  std::vector<std::string> names{""};
  for (const char c : *param.option) {
    if (c == ',')
      names.emplace_back();
    else
      names.back() += c;
  }
  return names;
}

/// Word for a value, as the help calls it.
std::string type_of(const Param& param, const Schema& schema) {
  if (schema.kind == Kind::kNumber) return "NUMBER";
  if (schema.kind == Kind::kInteger) return "INTEGER";
  if (schema.kind == Kind::kMap) return param.form;
  if (schema.kind == Kind::kList && schema.element->kind == Kind::kObject)
    return range_form(*schema.element);
  return "TEXT";
}

/// Adds the option of one parameter.
void add_option(CLI::App& command, const Param& param, Json& request) {
  const std::string key = param.key_in(UnitSystem::kPrinted);
  const Schema schema = param.schema_in(UnitSystem::kPrinted);
  const std::string help = help_of(param, schema);
  // A flag has a callback for each of its names; "!" marks one that turns it off.
  if (schema.kind == Kind::kFlag) {
    for (const std::string& name : option_names(param)) {
      const bool inverse = name.front() == '!';
      const bool has_own_help = inverse && !param.off_description.empty();
      command.add_flag_callback(
          "--" + name.substr(inverse ? 1 : 0),
          [&request, key, inverse] { request[key] = !inverse; },
          has_own_help ? without_stop(param.off_description) : help);
    }
    return;
  }
  // A positional parameter has no dashes; all names of an option mean the same.
  std::string spec = param.is_positional ? param.member.name : "";
  for (const std::string& name : option_names(param))
    if (!param.is_positional) spec += (spec.empty() ? "--" : ",--") + name;
  CLI::Option* option = nullptr;
  // Lists and maps take several words, all others one.
  if (schema.kind == Kind::kList || schema.kind == Kind::kMap) {
    option = command.add_option_function<std::vector<std::string>>(
        spec,
        [&request, key, schema, form = param.form](const std::vector<std::string>& texts) {
          request[key] = schema.kind == Kind::kMap ? typed_map(schema, form, texts)
                                                   : typed_list(schema, texts);
        },
        help);
    if (schema.kind == Kind::kList && schema.min_size == schema.max_size)
      option->expected(static_cast<int>(schema.max_size));
  } else {
    option = command.add_option_function<std::string>(
        spec,
        [&request, key, schema, name = option_names(param).front()](const std::string& text) {
          request[key] = in_field(name.c_str(), [&] {
            return schema.kind == Kind::kText ? Json(text)
                                              : typed_number(schema, text, what_is(schema));
          });
        },
        help);
  }
  // Show the default in the unit in which the option is typed.
  option->default_str(shown_default(param))->type_name(type_of(param, schema));
  if (param.member.required) option->required();
}

/// Text of an error that begins with a key of a parameter, by the name of its option instead.
std::string by_option(const Param& param, const std::string& text, const std::string& option) {
  const std::string& name = param.member.name;
  for (const std::string& key : {param.key_in(UnitSystem::kPrinted), name})
    if (text.rfind(key + ":", 0) == 0 || text.rfind(key + ".", 0) == 0)
      return option + text.substr(key.size());
  return text;
}

}  // namespace

InputError option_error(const std::vector<Param>& params, const InputError& error) {
  for (const Param& param : params) {
    if (param.member.name != error.field() || !param.option || param.option->empty()) continue;
    const std::string option = option_names(param).front();
    return InputError(by_option(param, text_with_commands(error), option), option);
  }
  return InputError(text_with_commands(error), error.field());
}

void ask_and_deliver(const TypedQuestion& typed) {
  const Question& question = *typed.question;
  try {
    Answer answer = question.ask(typed.request, "", terminal_progress("what is done is kept"));
    if (typed.allow_unconverged) answer.refusal.clear();
    set_request(question.name, answer.request);
    deliver(typed.outputs, answer);
  } catch (const InputError& error) {
    throw option_error(question.params, error);
  }
}

std::vector<Param> without(std::vector<Param> params, const std::vector<std::string>& names) {
  erase_where(params, [&](const Param& param) { return contains(names, param.member.name); });
  return params;
}

void add_request_options(CLI::App& command, const std::vector<Param>& params, Json& request) {
  for (const Param& param : params)
    if (param.option && !param.option->empty()) add_option(command, param, request);
}

std::pair<CLI::App*, std::shared_ptr<TypedQuestion>> add_question_command(
    CLI::App& app, const QuestionCommand& about) {
  auto typed = std::make_shared<TypedQuestion>();  // lives as long as the callback
  // The description of the question is the help of the command, without its full stop.
  typed->question = &question_named(about.question);
  std::string help = typed->question->description;
  help.pop_back();
  CLI::App* command = app.add_subcommand(about.name, help);
  add_request_options(*command, typed->question->params, typed->request);
  add_output_options(*command, typed->outputs, {true, true, true});
  add_examples(*command, about.examples);
  command->callback([typed] { ask_and_deliver(*typed); });
  return {command, typed};
}

}  // namespace thenar
