"""The OpenAPI document as tests use it: what it says of requests and of their answers."""

import copy
import dataclasses
import json

import jsonschema

JSON = "application/json"
PROBLEM = "application/problem+json"


@dataclasses.dataclass
class Operation:
    method: str  # "GET"
    path: str  # "/v1/jobs/{job}"
    json: dict  # the operation object, with the parameters of its path

    @property
    def id(self):
        return self.json["operationId"]


class Document:
    def __init__(self, text):
        self.json = json.loads(text)
        components = self.json["components"]
        # What the document does not name is not answered either.
        self.schemas = {name: self.closed(schema) for name, schema in components["schemas"].items()}
        self.operations = {operation.id: operation for operation in self._operations()}

    def _operations(self):
        for path, item in self.json["paths"].items():
            shared = item.get("parameters", [])
            for method, operation in item.items():
                if method == "parameters":
                    continue
                parameters = [self.resolved(p) for p in shared + operation.get("parameters", [])]
                yield Operation(method.upper(), path, operation | {"parameters": parameters})

    def at(self, reference):
        """What stands where "#/components/..." points."""
        target = self.json
        for name in reference.removeprefix("#/").split("/"):
            target = target[name]
        return target

    def resolved(self, node):
        """What a reference stands for."""
        while "$ref" in node:
            node = self.at(node["$ref"])
        return node

    def closed(self, schema):
        """The schema with additionalProperties false wherever it names properties; allOf as one object."""
        if isinstance(schema, list):
            return [self.closed(entry) for entry in schema]
        if not isinstance(schema, dict):
            return schema
        schema = copy.copy(schema)
        for part in map(self.resolved, schema.pop("allOf", [])):
            for name in ("properties", "required"):
                both = schema.get(name, type(part[name])()), part[name]
                schema[name] = both[0] | both[1] if name == "properties" else both[0] + both[1]
        schema = {name: self.closed(value) for name, value in schema.items()}
        if isinstance(schema.get("properties"), dict):
            schema.setdefault("additionalProperties", False)
        return schema

    def errors_of(self, value, schema):
        """Why `value` is not as the closed `schema` says, with places."""
        root = {"components": {"schemas": self.schemas}} | self.closed(schema)
        validator = jsonschema.Draft202012Validator(root)
        return [
            f"/{'/'.join(map(str, error.absolute_path))}: {error.message[:300]}"
            for error in validator.iter_errors(value)
        ]

    def response(self, operation, status):
        """What the operation says of a status, else of any other."""
        responses = operation.json["responses"]
        return self.resolved(responses.get(str(status)) or responses["default"])

    def examples(self, content):
        """By name, from all media types of a "content"."""
        return {
            name: self.resolved(example)["value"]
            for media in content.values()
            for name, example in media.get("examples", {}).items()
        }

    def requests(self, operation):
        """The examples of the operation's body, by name."""
        return self.examples(operation.json.get("requestBody", {}).get("content", {}))

    def status_of_example(self, operation, name):
        """Of the answer that has an example of that name."""
        return next(
            int(status)
            for status in operation.json["responses"]
            if status.isdigit() and name in self.examples(self.response(operation, int(status)).get("content", {}))
        )

    def problems_of_answer(self, operation, reply):
        """In what an answer is not as the document says."""
        if str(reply.status) not in operation.json["responses"] and reply.status < 400:
            return [f"status {reply.status} is not in the document"]
        said = self.response(operation, reply.status)
        problems = []
        for name, header in said["headers"].items():
            header = self.resolved(header)
            value = reply.headers.get(name.lower())
            if value is None and header.get("required"):
                problems.append(f"there is no header {name}")
        media_type = reply.headers.get("content-type", "").split(";")[0]
        content = said.get("content", {})
        if not content:
            return problems + (["there is a body"] if reply.body else [])
        if media_type not in content and "*/*" not in content:
            return problems + [f"media type {media_type} is not in the document"]
        if media_type in (JSON, PROBLEM) and media_type in content:
            problems += self.errors_of(reply.json(), content[media_type]["schema"])
        return problems
