"""What help, man pages and completion say, and that they leave nothing out."""

import json
import pathlib
import re
import subprocess
import unittest

from helps import NOTICE, about, commands, flags, help_of
from plan_runs import VALVE, options
from process_runs import HANGS_S
from programs import BAD_INPUT, COAPT, OK, SERVER, SOURCE, coapt

COMPLETION = SOURCE / "clients/cli/completion/coapt.bash"


class Help(unittest.TestCase):
    def test_every_command_has_an_example_and_says_what_coapt_is_not(self):
        for words, text in commands(COAPT):
            with self.subTest(" ".join(words[1:])):
                self.assertIn(NOTICE, text)
                self.assertRegex(text, rf"\n  (.*\| )?coapt {' '.join(words[1:])}\b")
        self.assertIn(NOTICE, help_of(COAPT))
        self.assertIn(NOTICE, help_of(SERVER))

    def test_without_arguments_it_prints_its_help_as_an_error(self):
        nothing = coapt()
        self.assertEqual((nothing.returncode, nothing.stdout), (BAD_INPUT, ""))
        self.assertEqual(nothing.stderr, help_of(COAPT))

    def test_commands_of_the_laboratory_say_where_they_went(self):
        for words in (["bench", "closures", "human-normal", "--count", "3"], ["chart", "--help"]):
            moved = coapt(*words)
            self.assertEqual((moved.returncode, moved.stdout), (BAD_INPUT, ""))
            self.assertRegex(moved.stderr, rf"^coapt: {words[0]}: .*coapt-lab {words[0]}.*\n$")
            self.assertNotIn(f"  {words[0]}", help_of(COAPT))

    def test_the_version_says_what_coapt_is_not(self):
        self.assertRegex(coapt("--version").stdout, about("coapt"))

    def test_the_version_as_json_says_what_a_closure_can_be_repeated_with(self):
        for program in (COAPT, SERVER):
            run = subprocess.run([program, "--version", "--json"], capture_output=True, text=True)
            build, name = json.loads(run.stdout), pathlib.Path(program).name
            self.assertEqual((run.returncode, build["program"], build["notice"]), (OK, name, NOTICE))
            told = "{program} {version}\nrevision {revision[git]}, closures {revision[closures]}, plans {revision[plans]}\n"
            plain = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
            self.assertTrue(plain.startswith(told.format(**build)), plain)
            self.assertIn(build["instruction_set"], ("portable", "baseline", "avx2", "avx512"))
            self.assertRegex(build["compiler"], r"^(g|clang)\+\+ \d+\.")
            alone = subprocess.run([program, "--json"], capture_output=True, text=True)
            self.assertEqual((alone.returncode, alone.stdout), (BAD_INPUT, ""))
            self.assertIn("--version", alone.stderr)

    def test_a_server_with_bad_flags_does_not_start(self):
        run = subprocess.run([SERVER, "--port", "x"], capture_output=True, text=True)
        self.assertEqual(run.returncode, BAD_INPUT)

    def test_a_server_with_flags_that_do_not_fit_together_does_not_start(self):
        for flags_, named in (
            (("--streams", 65), ("--streams is 65", "at most 64")),
            (("--requests", 32, "--streams", 16), ("--requests is 32", "at least 38")),
        ):
            run = subprocess.run(
                [SERVER, "--port", "0", *map(str, flags_)], capture_output=True, text=True, timeout=HANGS_S
            )
            self.assertEqual(run.returncode, BAD_INPUT)
            for words in named:
                self.assertIn(words, run.stderr)


class ManPages(unittest.TestCase):
    def section(self, page, heading):
        """Of the page of scdoc; the first line below the heading that begins so."""
        text = (SOURCE / f"docs/man/{page}.1.scd").read_text()
        found = re.search(rf"^##? {heading}\b.*?(?=^#|\Z)", text, re.MULTILINE | re.DOTALL)
        self.assertIsNotNone(found, f"{page} has no section {heading}")
        return found.group()

    def test_every_flag_of_every_command_is_in_its_section(self):
        for words, text in commands(COAPT):
            name = " ".join(["coapt", *words[1:]])
            section = self.section("coapt", name)
            for flag in flags(text) - {"-h", "--help"}:
                self.assertIn(f"*{flag}*", section, f"coapt.1.scd, {name}")

    def test_no_section_has_a_flag_that_is_gone(self):
        for words, text in commands(COAPT):
            name = " ".join(["coapt", *words[1:]])
            described = re.findall(r"^\*(-.*?)\*(?: _|$|, )", self.section("coapt", name), re.MULTILINE)
            self.assertLessEqual(set(described), flags(text), name)

    def test_every_flag_of_the_server_is_described(self):
        described = self.section("coapt-server", "OPTIONS") + self.section("coapt-server", "LIMITS")
        for flag in flags(help_of(SERVER)):
            self.assertIn(f"*{flag}*", described)


class Completion(unittest.TestCase):
    def complete(self, *words):
        """What is offered for the last of the words."""
        line = " ".join(words).replace(" : ", ":")
        script = (
            f'source {COMPLETION}; COMP_LINE=$0; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
            'COMP_POINT=${#COMP_LINE}; _coapt; printf "%s\\n" "${COMPREPLY[@]}"'
        )
        run = subprocess.run(["bash", "-c", script, line, *words], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (OK, ""), line)
        return set(run.stdout.split())

    def test_every_flag_of_every_command_is_offered(self):
        for words, text in commands(COAPT):
            self.assertEqual(self.complete(*words, "-"), flags(text), words)
        self.assertEqual(
            self.complete(SERVER, "--"), {flag for flag in flags(help_of(SERVER)) if flag.startswith("--")}
        )

    def test_commands_are_offered_by_their_beginning(self):
        self.assertEqual(
            self.complete(COAPT, ""),
            {
                *(
                    "valve",
                    "close",
                    "compare",
                    "design",
                    "diagnose",
                    "export",
                    "fit",
                    "evaluate",
                    "observe",
                    "operations",
                    "open",
                    "plan",
                    "population",
                ),
                *("prefer", "presets", "study", "train"),
            },
        )
        self.assertEqual(self.complete(COAPT, "valve", "re"), {"remodel"})
        self.assertEqual(self.complete(COAPT, "study", "porcine-", "--prot"), set())
        self.assertEqual(self.complete(COAPT, "plan", "--seed", "3", "human-normal", "--ev"), {"--evaluations"})

    def test_presets_are_those_of_the_program(self):
        said = coapt("close", "no-such-valve").stderr
        presets = set(re.search(r"not a preset \((.*)\)", said).group(1).split(", "))
        self.assertEqual(self.complete(COAPT, "close", ""), presets)
        self.assertEqual(self.complete(COAPT, "plan", "human-p"), {"human-p2-prolapse"})

    def test_values_are_those_that_the_program_takes(self):
        for option, before in [
            ("--method", ["close"]),
            ("--membrane", ["close"]),
            ("--protocol", ["study", "thesis"]),
            ("--displacement-step", ["study", "thesis"]),
        ]:
            offered = self.complete(COAPT, *before, option, "")
            self.assertGreater(len(offered), 1)
            for value in offered:
                said = coapt(*before, "no-such-valve", option, value).stderr
                self.assertNotIn(option, said)

    def test_what_may_be_forbidden_is_what_the_search_knows(self):
        said = coapt("plan", VALVE, *options(), "--forbid", "nonsense").stderr
        known = set(re.search(r"must be one of (.*)", said).group(1).split(", "))
        self.assertEqual(self.complete(COAPT, "plan", "--forbid", ""), known)
        self.assertEqual(
            self.complete(COAPT, "plan", "--forbid", "papillary_approximation", ":", "sad"), {"saddle_peak"}
        )


if __name__ == "__main__":
    unittest.main()
