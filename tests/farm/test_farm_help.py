"""Help, man page and completion of coapt-farm."""

import os
import re
import subprocess
import unittest

from farm_runs import BAD_INPUT, OK
from helps import NOTICE, about, commands, flags
from programs import SOURCE

FARM = os.environ["COAPT_FARM_PROGRAM"]


class Help(unittest.TestCase):
    def test_every_command_has_an_example_and_says_what_coapt_is_not(self):
        for words, text in commands(FARM):
            self.assertIn(NOTICE, text)
            self.assertRegex(text, rf"\n  coapt-farm {' '.join(words[1:])}\b")
        version = subprocess.run([FARM, "--version"], capture_output=True, text=True).stdout
        self.assertRegex(version, about("coapt-farm"))

    def test_a_command_without_a_database_is_a_usage_error(self):
        for words, _ in commands(FARM):
            environment = {name: value for name, value in os.environ.items() if name != "COAPT_FARM"}
            run = subprocess.run([*words, "1"], capture_output=True, text=True, env=environment)
            self.assertEqual((run.returncode, run.stdout), (BAD_INPUT, ""), words)

    def test_the_man_page_has_every_flag_of_every_command_and_no_other(self):
        page = (SOURCE / "docs/man/coapt-farm.1.scd").read_text()
        for words, text in commands(FARM):
            name = " ".join(["coapt-farm", *words[1:]])
            section = re.search(rf"^## {name}\n.*?(?=^#|\Z)", page, re.MULTILINE | re.DOTALL).group()
            described = set(re.findall(r"^\*(-.*?)\*", section, re.MULTILINE))
            described |= set(re.findall(r"^\*-.\*, \*(--.*?)\*", section, re.MULTILINE))
            self.assertEqual(described | {"-h", "--help", "--db"}, flags(text), name)

    def test_completion_offers_commands_and_flags(self):
        script = (
            f'source {SOURCE}/clients/cli/completion/coapt.bash; COMP_LINE=$0; COMP_WORDS=("$@"); '
            'COMP_CWORD=$(($# - 1)); COMP_POINT=${#COMP_LINE}; _coapt; printf "%s\\n" "${COMPREPLY[@]}"'
        )
        for words, expected in (
            ((FARM, ""), {"init", "add", "work", "status", "fetch", "cancel", "forget"}),
            ((FARM, "work", "--un"), {"--until-dry"}),
        ):
            run = subprocess.run(["bash", "-c", script, " ".join(words), *words], capture_output=True, text=True)
            self.assertEqual((run.returncode, set(run.stdout.split())), (OK, expected))


if __name__ == "__main__":
    unittest.main()
