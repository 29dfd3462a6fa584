"""What the OpenAPI document says of each field, to people and to generators of clients; no server is needed."""

import subprocess
import unittest

from openapi_document import Document
from programs import SOURCE, ProgramTest


def objects_in(node, place=""):
    """Every object of the document with its place, but those of examples."""
    if isinstance(node, dict):
        yield place, node
    members = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for name, member in members:
        if name != "examples":
            yield from objects_in(member, f"{place}/{name}")


class Schemas(ProgramTest):
    def setUp(self):
        super().setUp()
        file = self.folder / "openapi.json"
        subprocess.run(["cmake", "-D", f"OUTPUT={file}", "-P", SOURCE / "server/openapi.cmake"], check=True)
        self.document = Document(file.read_text())

    def is_described(self, schema):
        reference = schema.get("$ref")
        return "description" in schema or reference is not None and self.is_described(self.document.at(reference))

    def values(self, schema, field):
        """That `field` may have in a variant of a union, or in the variants of that."""
        schema = self.document.resolved(schema)
        if "oneOf" in schema:
            return {value for variant in schema["oneOf"] for value in self.values(variant, field)}
        said = self.document.resolved(schema["properties"][field])
        self.assertIn(field, schema["required"])
        return set(said.get("enum", [said.get("const")]))

    def test_every_field_has_a_description(self):
        fields = [
            (f"{place}/{name}", schema)
            for place, node in objects_in(self.document.json)
            for name, schema in node.get("properties", {}).items()
        ]
        self.assertTrue(fields)
        self.assertEqual([place for place, schema in fields if not self.is_described(schema)], [])

    def test_a_discriminator_names_each_variant_by_all_values_that_it_has(self):
        unions = [(place, node) for place, node in objects_in(self.document.json) if "discriminator" in node]
        self.assertTrue(unions)
        for place, union in unions:
            with self.subTest(place):
                mapping = union["discriminator"]["mapping"]
                field = union["discriminator"]["propertyName"]
                for variant in union["oneOf"]:
                    named = {value for value, target in mapping.items() if target == variant["$ref"]}
                    self.assertEqual(self.values(variant, field), named)
                self.assertEqual(set(mapping.values()), {variant["$ref"] for variant in union["oneOf"]})


if __name__ == "__main__":
    unittest.main()
