"""The HTTP interface as pages: one for each tag of the OpenAPI document, and one of its schemas."""

import json
import re

from pages import anchor

_LONGEST_LIST = 6  # of an example, in numbers
_RANGES = (("", "minimum", "maximum"), (" characters", "minLength", "maxLength"), (" entries", "minItems", "maxItems"))
_METHODS = ("get", "post", "put", "patch", "delete")


def rest_pages(document):
    """Name and text of each page."""
    names = {tag["name"]: tag["name"].replace(" ", "-") + ".md" for tag in document["tags"]}
    pages = {"index.md": _index(document, names), "schemas.md": _schemas(document)}
    for tag in document["tags"]:
        parts = [f"# {tag['name'].capitalize()}", tag["description"]]
        for method, path, operation in _operations(document, tag["name"]):
            parts += _operation(document, method, path, operation)
        pages[names[tag["name"]]] = "\n\n".join(part for part in parts if part) + "\n"
    return pages


def _operations(document, tag):
    for path, methods in document["paths"].items():
        for method in _METHODS:
            if tag in methods.get(method, {}).get("tags", ()):
                shared = methods.get("parameters", [])
                operation = methods[method]
                yield method, path, operation | {"parameters": shared + operation.get("parameters", [])}


def _index(document, names):
    parts = [
        "# REST interface",
        document["info"]["description"],
        "The service answers the [OpenAPI 3.1](https://spec.openapis.org/oas/v3.1.0) document that these pages are made of at"
        " `/openapi.json`. [Service](../../engineer/service.md) shows it at work.",
    ]
    for tag in document["tags"]:
        rows = [
            f"| [`{method.upper()} {path}`]({names[tag['name']]}#{anchor(f'{method} {path}')}) | {operation['summary']} |"
            for method, path, operation in _operations(document, tag["name"])
        ]
        parts += [f"## {tag['name'].capitalize()}", tag["description"], "\n".join(["| | |", "|---|---|", *rows])]
    parts += ["## Errors", "Answers that any request may have, each with a [Problem](schemas.md#problem)."]
    parts += [document["components"]["responses"]["OtherProblem"]["description"]]
    listed = "\n".join(name.removesuffix(".md") for name in [*names.values(), "schemas.md"])
    return "\n\n".join([*parts, f"```{{toctree}}\n:hidden:\n\n{listed}\n```"]) + "\n"


def _operation(document, method, path, operation):
    yield f"## {method.upper()} {path}"
    yield f"{operation['summary']}."
    yield operation.get("description", "")
    if operation["parameters"]:
        rows = []
        for parameter in (_resolved(document, one) for one in operation["parameters"]):
            needed = ", needed" if parameter.get("required") and parameter["in"] != "path" else ""
            said = [parameter.get("description", ""), _limits(parameter["schema"])]
            rows.append((f"`{parameter['name']}`", parameter["in"] + needed, _type(parameter["schema"]), _joined(said)))
        yield _table(("parameter", "in", "type", ""), rows)
    if "requestBody" in operation:
        body = _resolved(document, operation["requestBody"])
        for media, content in body["content"].items():
            yield f"**Body**, `{media}`: {_type(content.get('schema', {}))}"
            yield _fields(content.get("schema", {}))
            yield from _examples(document, content, "Body")
    yield from _answers(document, operation)


def _answers(document, operation):
    rows, examples = [], []
    for status, answer in operation["responses"].items():
        if status == "default":
            rows.append(("others", "[as any request](index.md#errors)", "`application/problem+json`"))
            continue
        answer = _resolved(document, answer)
        kinds = [
            f"`{media}`" + (f" {_type(content['schema'])}" if "$ref" in content.get("schema", {}) else "")
            for media, content in answer.get("content", {}).items()
        ]
        rows.append((status, answer.get("description", ""), "<br>".join(kinds)))
        for content in answer.get("content", {}).values():
            if status[0] in "23":
                examples += _examples(document, content, f"Answer {status}")
    yield _table(("answer", "", "content"), rows)
    yield from examples


def _examples(document, content, title):
    for name, example in content.get("examples", {}).items():
        value = _resolved(document, example).get("value")
        text = value if isinstance(value, str) else _json(value)
        language = "text" if isinstance(value, str) else "json"
        words = f"{title}: {name.replace('_', ' ')}"
        yield f"<details><summary>{words}</summary>\n\n```{language}\n{text.rstrip()}\n```\n\n</details>"


def _json(value):
    """Long lists are cut, lists of numbers stand in one line."""

    def cut(one):
        if isinstance(one, list):
            shown = [cut(entry) for entry in one[:_LONGEST_LIST]]
            return shown + [f"... {len(one) - len(shown)} more"] if len(one) > len(shown) else shown
        return {name: cut(entry) for name, entry in one.items()} if isinstance(one, dict) else one

    def in_one_line(found):
        return "[" + re.sub(r"\s+", " ", found[1]) + "]"

    return re.sub(r"\[\s+([^\[\]{}]*?)\s+\]", in_one_line, json.dumps(cut(value), indent=2, ensure_ascii=False))


def _schemas(document):
    parts = ["# Schemas", "What bodies and answers are made of. A field that may be left out is marked so."]
    for name, schema in document["components"]["schemas"].items():
        parts += [f"## {name}", schema.get("description", ""), _kind(schema), _fields(schema)]
    return "\n\n".join(part for part in parts if part) + "\n"


def _kind(schema):
    """Of what is no object with fields of its own."""
    if "properties" in schema or "allOf" in schema:
        return ""
    return _joined([_type(schema) + ".", _limits(schema)])


def _fields(schema):
    """A table of an object's fields; those of objects within it follow, named by their path."""
    rows = []

    def gather(one, prefix):
        for part in one.get("allOf", ()):
            if "$ref" in part:
                rows.append(("", f"all of {_type(part)}", ""))
            gather(part, prefix)
        needed = one.get("required", ())
        for name, field in one.get("properties", {}).items():
            optional = "" if name in needed else "may be left out"
            rows.append(
                (f"`{prefix}{name}`", _type(field), _joined([field.get("description", ""), _limits(field), optional]))
            )
            inner = field.get("items", field) if isinstance(field.get("items", field), dict) else {}
            if "properties" in inner:
                gather(inner, f"{prefix}{name}{'[]' if inner is not field else ''}.")

    gather(schema, "")
    return _table(("field", "type", ""), rows) if rows else ""


def _type(schema):
    if "$ref" in schema:
        name = schema["$ref"].removeprefix("#/components/schemas/")
        top = name.split("/")[0]
        return f"[{name.replace('/properties/', '.').replace('/', '.')}](schemas.md#{anchor(top)})"
    if "const" in schema:
        return f"`{json.dumps(schema['const'])}`"
    if "enum" in schema:
        return " ".join(f"`{json.dumps(value)}`" for value in schema["enum"])
    for several in ("oneOf", "anyOf", "allOf"):
        if several in schema:
            return (" and " if several == "allOf" else " or ").join(map(_type, schema[several]))
    kinds = schema.get("type", "object" if "properties" in schema else "anything")
    kinds = [kinds] if isinstance(kinds, str) else kinds
    if "array" in kinds and isinstance(schema.get("items"), dict):
        kinds = [f"array of {_type(schema['items'])}" if kind == "array" else kind for kind in kinds]
    return " or ".join(kinds)


def _limits(schema):
    """In words."""
    said = []
    for unit, least, most in _RANGES:
        low, high = schema.get(least), schema.get(most)
        if low is not None and low == high:
            said.append(f"{low}{unit}")
        elif low is not None and high is not None:
            said.append(f"{low} to {high}{unit}")
        elif low is not None or high is not None:
            said.append(f"{low}{unit} or more" if high is None else f"{high}{unit} at most")
    if "exclusiveMinimum" in schema:
        said.append(f"above {schema['exclusiveMinimum']}")
    if "pattern" in schema:
        said.append(f"matches `{schema['pattern']}`")
    if "default" in schema:
        said.append(f"`{json.dumps(schema['default'])}` by default")
    return ", ".join(said)


def _joined(sentences):
    return "; ".join(one.rstrip(".") if one is not sentences[-1] else one for one in sentences if one)


def _table(head, rows):
    def cell(text):
        return text.strip().replace("\n- ", "<br>").replace("\n", " ").replace("|", "\\|")

    lines = [" | ".join(head), "|".join("---" for _ in head), *(" | ".join(map(cell, row)) for row in rows)]
    return "\n".join(f"| {line} |" for line in lines)


def _resolved(document, thing):
    while "$ref" in thing:
        target = document
        for part in thing["$ref"].removeprefix("#/").split("/"):
            target = target[part]
        thing = target
    return thing
