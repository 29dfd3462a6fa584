"""What the help and the man page of coapt-lab say, and that they leave nothing out."""

import re
import unittest

from helps import NOTICE, about, commands, flags, help_of
from laboratory import LAB, coapt_lab
from programs import BAD_INPUT, SOURCE


class Help(unittest.TestCase):
    def test_every_command_has_an_example_and_says_what_coapt_is_not(self):
        for words, text in commands(LAB):
            with self.subTest(" ".join(words[1:])):
                self.assertIn(NOTICE, text)
                self.assertIn(f"\n  coapt-lab {' '.join(words[1:])} ", text)
        self.assertIn(NOTICE, help_of(LAB))

    def test_without_arguments_it_prints_its_help_as_an_error(self):
        nothing = coapt_lab()
        self.assertEqual((nothing.returncode, nothing.stdout), (BAD_INPUT, ""))
        self.assertEqual(nothing.stderr, help_of(LAB))

    def test_the_version_says_what_coapt_is_not(self):
        self.assertRegex(coapt_lab("--version").stdout, about("coapt-lab"))

    def test_the_man_page_describes_the_flags_of_every_command_and_no_others(self):
        page = (SOURCE / "docs/man/coapt-lab.1.scd").read_text()
        for words, text in commands(LAB):
            name = " ".join(["coapt-lab", *words[1:]])
            section = re.search(rf"^## {name}\b.*?(?=^#|\Z)", page, re.MULTILINE | re.DOTALL).group()
            described = {
                flag
                for line in re.findall(r"^\*-.*", section, re.MULTILINE)
                for flag in re.findall(r"\*(-.*?)\*", line)
            }
            self.assertEqual(described, flags(text) - {"-h", "--help"}, name)


if __name__ == "__main__":
    unittest.main()
