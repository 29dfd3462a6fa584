"""The package's own modules: none imports itself by way of others, be it for a type or within a function."""

import ast
import graphlib
import unittest

from programs import SOURCE

PACKAGE = SOURCE / "clients/python/coapt"


def imported(file):
    found = [one for one in ast.walk(ast.parse(file.read_text())) if isinstance(one, ast.ImportFrom) and one.level]
    return {name for one in found for name in ([one.module] if one.module else [alias.name for alias in one.names])}


class Modules(unittest.TestCase):
    def test_imports_form_no_circle(self):
        modules = {file.stem: imported(file) for file in (*PACKAGE.glob("*.py"), *PACKAGE.glob("*.pyi"))}
        self.assertIn("transport", modules["client"] | modules["http_transport"])
        graphlib.TopologicalSorter(modules).prepare()  # CycleError names one


if __name__ == "__main__":
    unittest.main()
