// SPDX-License-Identifier: GPL-3.0-or-later
// confidel completion SHELL, confidel manual [COMMAND]: made from the command line's own declaration, so that they cannot be stale.
// Both are hidden: packages run them, people read the results.
#include <fmt/format.h>

#include <memory>
#include <vector>

#include "apps/command.h"

namespace confidel {
namespace {

struct OptionText {
  std::vector<std::string> names;  ///< with dashes; empty for a positional
  std::string placeholder;         ///< empty for a flag
  std::vector<std::string> choices;
  std::string description;
};

struct CommandText {
  std::string name, description, footer;
  std::vector<OptionText> options, positionals;
};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) parts.emplace_back();
    else parts.back() += c;
  }
  return parts;
}

/// The values that an option accepts, where its help shows them: `TEXT:{a,b}` or `a|b`.
std::vector<std::string> choices_in(const std::string& text) {
  const std::size_t open = text.find('{'), close = text.find('}', open);
  if (open != std::string::npos && close != std::string::npos) return split(text.substr(open + 1, close - open - 1), ',');
  if (text.find('|') != std::string::npos) return split(text.substr(text.find_first_not_of(' ')), '|');
  return {};
}

OptionText text_of(const CLI::Option& option) {
  OptionText result;
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  if (option.get_positional()) result.names.clear();
  result.description = option.get_description();
  if (option.get_items_expected_max() > 0 || option.get_positional()) {
    const std::string shown = CLI::Formatter().make_option_opts(&option);
    result.choices = choices_in(shown);
    const std::string type = split(option.get_type_name(), ':').front();
    result.placeholder = option.get_positional() ? option.get_single_name() : type.empty() ? "VALUE" : type;
    if (!result.choices.empty()) {
      result.placeholder.clear();
      for (const std::string& choice : result.choices) result.placeholder += (result.placeholder.empty() ? "" : "|") + choice;
    }
  }
  return result;
}

CommandText text_of(const CLI::App& command) {
  CommandText result{command.get_name(), command.get_description(), command.get_footer(), {}, {}};
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    (option->get_positional() ? result.positionals : result.options).push_back(text_of(*option));
  }
  return result;
}

std::vector<CommandText> commands_of(const CLI::App& app) {
  std::vector<CommandText> result;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* each) { return !each->get_group().empty(); })) result.push_back(text_of(*command));
  return result;
}

// Manual pages.

std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') result += "\\e";
    else if (c == '-') result += "\\-";
    else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) result += fmt::format("\\&{}", c);
    else result += c;
  }
  return result;
}

std::string roff(const OptionText& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "\\fB" : "\\fR, \\fB") + roff(name);
  if (!names.empty()) names += "\\fR";
  if (!option.placeholder.empty()) names += (names.empty() ? "\\fI" : " \\fI") + roff(option.placeholder) + "\\fR";
  return fmt::format(".TP\n{}\n{}\n", names, roff(option.description));
}

std::string roff_footer(const std::string& footer) {
  const std::size_t blank = std::min(footer.find("\n\n"), footer.size());
  std::string result;
  const std::string examples = footer.substr(0, blank);
  if (examples.find('\n') != std::string::npos) result += ".SH EXAMPLES\n.nf\n" + roff(examples.substr(examples.find('\n') + 1)) + "\n.fi\n";
  if (blank < footer.size()) result += ".SH EXIT STATUS\n" + roff(footer.substr(blank + 2)) + "\n";
  return result;
}

std::string page(const std::string& name, const CommandText& command, const std::string& between) {
  std::string synopsis = "\\fB" + roff(name.find('-') == std::string::npos ? name : "confidel " + command.name) + "\\fR";
  for (const OptionText& positional : command.positionals) synopsis += " \\fI" + roff(positional.placeholder) + "\\fR";
  std::string result = fmt::format(".TH {} 1 \"\" \"confidel {}\" \"Confidel\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{} [\\fIOPTIONS\\fR]{}\n", name, CONFIDEL_VERSION,
                                   roff(name), roff(command.description), synopsis, command.name == "confidel" ? " \\fICOMMAND\\fR ..." : "");
  if (!command.positionals.empty()) result += ".SH ARGUMENTS\n";
  for (const OptionText& positional : command.positionals) result += roff(positional);
  result += between + ".SH OPTIONS\n";
  for (const OptionText& option : command.options) result += roff(option);
  return result + roff_footer(command.footer);
}

std::string manual(const CLI::App& app, const std::string& wanted) {
  const std::vector<CommandText> commands = commands_of(app);
  std::string list = ".SH COMMANDS\n", pages;
  for (const CommandText& command : commands) {
    list += fmt::format(".TP\n\\fB{}\\fR\n{}; see \\fBconfidel\\-{}\\fR(1)\n", roff(command.name), roff(command.description), roff(command.name));
    pages += fmt::format("{}\\fBconfidel\\-{}\\fR(1)", pages.empty() ? "" : ", ", roff(command.name));
    if (command.name == wanted)
      return page("confidel-" + command.name, command, "") + ".SH SEE ALSO\n\\fBconfidel\\fR(1), \\fBconfidel\\-check\\fR(1)\n";
  }
  if (!wanted.empty()) throw CLI::ValidationError("COMMAND", "there is no command " + wanted);
  return page("confidel", text_of(app), list) + ".SH SEE ALSO\n" + pages + ", \\fBconfidel\\-check\\fR(1)\n";
}

// Completions.

std::string joined(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : " ") + word;
  return result;
}

std::vector<OptionText> all_options(const CLI::App& app, const CommandText& command) {
  std::vector<OptionText> options = command.options;
  const std::vector<OptionText> common = text_of(app).options;
  for (const OptionText& option : common)
    if (option.names.back() == "--color") options.push_back(option);
  return options;
}

std::string names_of(const std::vector<OptionText>& options) {
  std::vector<std::string> names;
  for (const OptionText& option : options) names.insert(names.end(), option.names.begin(), option.names.end());
  return joined(names);
}

std::string bash_completion(const CLI::App& app) {
  const std::vector<CommandText> commands = commands_of(app);
  std::vector<std::string> names;
  std::string cases, values;
  for (const CommandText& command : commands) {
    names.push_back(command.name);
    cases += fmt::format("    {}) options='{}' ;;\n", command.name, names_of(all_options(app, command)));
    for (const OptionText& option : all_options(app, command)) {
      if (option.placeholder.empty()) continue;
      std::string patterns;
      for (const std::string& name : option.names) patterns += (patterns.empty() ? "" : "|") + command.name + ":" + name;
      if (!option.choices.empty()) values += fmt::format("    {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", patterns, joined(option.choices));
    }
  }
  return fmt::format(R"(# bash completion for confidel, made by `confidel completion bash`
_confidel() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command= options= i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case ${{COMP_WORDS[i]}} in -*) ;; *) command=${{COMP_WORDS[i]}}; break ;; esac
  done
  case $command:$previous in
{}  esac
  case $command in
    '') COMPREPLY=($(compgen -W '{} {}' -- "$word")); return ;;
{}  esac
  case $word in
    -*) COMPREPLY=($(compgen -W "$options" -- "$word")) ;;
    *) COMPREPLY=($(compgen -f -- "$word")) ;;
  esac
}}
complete -o filenames -F _confidel confidel
)",
                     values, joined(names), names_of(text_of(app).options), cases);
}

/// In single quotes, for zsh's specifications and for fish.
std::string quoted(const std::string& text, const char* special) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') result += "'\\''";
    else if (std::string_view(special).find(c) != std::string_view::npos) result += fmt::format("\\{}", c);
    else result += c;
  }
  return result;
}

std::string zsh_completion(const CLI::App& app) {
  std::string list, cases;
  for (const CommandText& command : commands_of(app)) {
    list += fmt::format("    '{}:{}'\n", command.name, quoted(command.description, ":"));
    std::string arguments;
    for (const OptionText& option : all_options(app, command)) {
      for (const std::string& name : option.names) {
        const std::string value = option.placeholder.empty()  ? ""
                                  : option.choices.empty() ? ":value:_files"
                                                           : ":value:(" + joined(option.choices) + ")";
        arguments += fmt::format(" \\\n        '{}[{}]{}'", name, quoted(option.description, "[]:"), value);
      }
    }
    cases += fmt::format("      {}) _arguments{} \\\n        '*:file:_files' ;;\n", command.name, arguments);
  }
  return fmt::format(R"(#compdef confidel
# zsh completion for confidel, made by `confidel completion zsh`
_confidel() {{
  local -a commands
  commands=(
{}  )
  _arguments -C '1:command:->command' '*::argument:->argument'
  case $state in
    command) _describe command commands ;;
    argument)
      case $words[1] in
{}      esac ;;
  esac
}}
if [ "$funcstack[1]" = _confidel ]; then _confidel "$@"; else compdef _confidel confidel; fi
)",
                     list, cases);
}

std::string fish_completion(const CLI::App& app) {
  std::string result = "# fish completion for confidel, made by `confidel completion fish`\n";
  for (const CommandText& command : commands_of(app)) {
    result += fmt::format("complete -c confidel -f -n __fish_use_subcommand -a {} -d '{}'\n", command.name, quoted(command.description, ""));
    const std::string condition = fmt::format("-n '__fish_seen_subcommand_from {}'", command.name);
    for (const OptionText& option : all_options(app, command)) {
      std::string line = "complete -c confidel " + condition;
      for (const std::string& name : option.names) line += name[1] == '-' ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.choices.empty()) line += " -x -a '" + joined(option.choices) + "'";
      else if (!option.placeholder.empty()) line += " -r";
      result += line + fmt::format(" -d '{}'\n", quoted(option.description, ""));
    }
  }
  return result;
}

}  // namespace

void add_manual(CLI::App& app, Selection& selection) {
  auto shell = std::make_shared<std::string>(), wanted = std::make_shared<std::string>(), folder = std::make_shared<std::string>();
  CLI::App* completion = app.add_subcommand("completion", "Print the completion of a shell: bash, zsh, fish")->group("");
  completion->add_option("SHELL", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  completion->callback([shell, &app, &selection] {
    selection.run = [shell, &app] {
      write_output("", *shell == "bash" ? bash_completion(app) : *shell == "zsh" ? zsh_completion(app) : fish_completion(app));
      return exit_success;
    };
  });
  CLI::App* pages = app.add_subcommand("manual", "Print the manual page of confidel, or of one of its commands, for man(1)")->group("");
  pages->add_option("COMMAND", *wanted, "The command");
  pages->add_option("--output", *folder, "Write all pages into this folder instead");
  pages->callback([wanted, folder, &app, &selection] {
    const std::string text = manual(app, *wanted);
    selection.run = [text, folder, &app] {
      if (folder->empty()) {
        write_output("", text);
        return exit_success;
      }
      write_output(*folder + "/confidel.1", manual(app, ""));
      for (const CommandText& command : commands_of(app)) write_output(fmt::format("{}/confidel-{}.1", *folder, command.name), manual(app, command.name));
      return exit_success;
    };
  });
}

}  // namespace confidel
