#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""help_test.py BINARIES: examples in --help run; completions and manual pages name every command and option; colour obeys."""
import os
import re
import shutil
import subprocess
import sys
import tempfile

from harness import ROOT, Programs

# Their examples run for minutes, or on an input that is bad in a way of its own.
NOT_RUN = {"paper", "falsify", "shrink"}
HELP_OPTIONS = re.compile(r"^  (-\S+)", re.M)


def commands(programs):
    _, out, _ = programs.run("--help")
    return re.findall(r"^  ([a-z]+) ", out[out.index("Subcommands:"):].split("Examples:")[0], re.M)


def options(text):
    names = set()
    for names_text in HELP_OPTIONS.findall(text):
        names |= set(names_text.split(","))
    return names


def check_examples(programs, names):
    for name in [None] + names:
        arguments = ([name] if name else []) + ["--help"]
        code, out, _ = programs.run(*arguments)
        programs.expect(code == 0 and "Examples:" in out, "confidel %s: no examples" % " ".join(arguments))
        examples = re.findall(r"^  (confidel .*)$", out[out.find("Examples:"):], re.M)
        programs.expect(len(examples) >= 1, "confidel %s: no examples" % " ".join(arguments))
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(os.path.join(ROOT, "examples"), os.path.join(folder, "examples"))
            environment = dict(os.environ, PATH=os.path.dirname(programs.confidel) + os.pathsep + os.environ["PATH"])
            for example in examples if name not in NOT_RUN else ():
                done = subprocess.run(["bash", "-c", example], cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
                programs.expect(done.returncode == 0, "the example `%s` fails: %d %s" % (example, done.returncode, done.stderr[-300:]))


def check_manual(programs, names):
    with tempfile.TemporaryDirectory() as folder:
        for name in [None] + names:
            code, page, _ = programs.run("manual", *([name] if name else []))
            _, help_text, _ = programs.run(*([name] if name else []), "--help")
            plain = page.replace("\\-", "-").replace("\\e", "\\").replace("\\fB", "").replace("\\fR", "").replace("\\fI", "")
            programs.expect(code == 0 and page.startswith(".TH confidel"), "manual %s" % name)
            for option in options(help_text):
                programs.expect(option in plain, "manual %s: no %s" % (name, option))
            if name is None:
                for each in names:
                    programs.expect("confidel-" + each in plain, "manual: no " + each)
            else:
                description = re.sub(r"\s+", " ", help_text.split("Usage:")[0]).strip()
                programs.expect(description in plain, "manual %s: no description" % name)
            if shutil.which("groff"):
                done = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z"], input=page, capture_output=True, text=True)
                warnings = [line for line in done.stderr.splitlines() if "cannot adjust" not in line and "can't break" not in line]
                programs.expect(done.returncode == 0 and not warnings, "manual %s: groff says %s" % (name, warnings))
    programs.expect(programs.run("manual", "nonsense")[0] == 2, "manual nonsense")


def complete(script, words):
    """What bash offers for the last of the words."""
    program = "%s\nCOMP_WORDS=(%s)\nCOMP_CWORD=%d\n_confidel\nprintf '%%s\\n' \"${COMPREPLY[@]}\"" % (
        script, " ".join("'%s'" % word for word in words), len(words) - 1)
    done = subprocess.run(["bash", "-c", program], capture_output=True, text=True)
    return set(done.stdout.split())


def check_completions(programs, names):
    code, bash, _ = programs.run("completion", "bash")
    programs.expect(code == 0 and complete(bash, ["confidel", ""]) >= set(names), "bash completes commands: %s" % complete(bash, ["confidel", ""]))
    programs.expect(complete(bash, ["confidel", "conf"]) == {"conform"}, "bash: conf")
    programs.expect(complete(bash, ["confidel", "conform", "--strategy", "l"]) == {"lean"}, "bash completes values")
    for name in names:
        offered = complete(bash, ["confidel", name, "-"])
        _, help_text, _ = programs.run(name, "--help")
        programs.expect(offered >= options(help_text) | {"--color"}, "bash: options of %s: %s" % (name, options(help_text) - offered))
        for shell in ("zsh", "fish"):
            code, text, _ = programs.run("completion", shell)
            programs.expect(code == 0 and name in text, "%s: no %s" % (shell, name))
            for option in options(help_text):
                written = option if shell == "zsh" else ("-l " + option[2:] if option.startswith("--") else "-s " + option[1:])
                programs.expect(written in text, "%s: no %s of %s" % (shell, written, name))
    for shell, arguments in (("zsh", ["-n"]), ("fish", ["-n"])):
        if shutil.which(shell):
            with tempfile.NamedTemporaryFile("w", suffix="." + shell) as file:
                file.write(programs.run("completion", shell)[1])
                file.flush()
                programs.expect(subprocess.run([shell, *arguments, file.name], capture_output=True).returncode == 0, shell + " does not read its completion")
    programs.expect(programs.run("completion", "csh")[0] == 2, "completion csh")


def check_colour(programs):
    missing = ("info", "/no/such/file.off")
    bare = dict(os.environ, TERM="xterm")
    bare.pop("NO_COLOR", None)
    programs.expect("\x1b" not in programs.run(*missing, env=bare)[2], "colour in a pipe")
    programs.expect("\x1b[1;31m" in programs.run(*missing, "--color", "always", env=bare)[2], "--color always")
    programs.expect("\x1b[1;31m" in programs.run("--color=always", *missing, env=bare)[2], "--color=always before the command")
    programs.expect(programs.run(*missing, "--color", "perhaps")[0] == 2, "--color perhaps")
    script = "import pty, sys; sys.exit(pty.spawn(sys.argv[1:]) >> 8)"
    for environment, coloured in ((bare, True), (dict(bare, NO_COLOR="1"), False), (dict(bare, NO_COLOR=""), True), (dict(bare, TERM="dumb"), False)):
        done = subprocess.run([sys.executable, "-c", script, programs.confidel, *missing], env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        programs.expect(("\x1b[1;31m" in done.stdout) == coloured, "on a terminal, coloured %s: %r" % (coloured, done.stdout))
        never = subprocess.run([sys.executable, "-c", script, programs.confidel, *missing, "--color", "never"], env=environment, stdin=subprocess.DEVNULL,
                               capture_output=True, text=True)
        programs.expect("\x1b[1;31m" not in never.stdout, "--color never")


def main():
    programs = Programs(sys.argv[1])
    names = commands(programs)
    programs.expect({"info", "canonical", "conform", "explain"} <= set(names), "commands: %s" % names)
    check_examples(programs, names)
    check_manual(programs, names)
    check_completions(programs, names)
    check_colour(programs)
    programs.finish()


main()
