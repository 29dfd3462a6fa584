#!/usr/bin/env python3
"""Fails if a bill of materials breaks a rule of SPDX 2.3, or is not that of the artefact beside it.

Usage: check_sbom.py ARTEFACT.spdx.json...

The rules are those of the specification, clauses 6 (document), 7 (packages), 8 (files) and 11 (relationships): which fields there must
be and of what form. The specification's own schema is in no package of Debian or npm.
"""
import hashlib
import json
import pathlib
import re
import sys

import sbom_parts

IDENTIFIER = re.compile(r"SPDXRef-[A-Za-z0-9.-]+")
TIME = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ")
CREATOR = re.compile(r"(Person|Organization|Tool): \S.*")
NAMESPACE = re.compile(r"[a-z][a-z0-9+.-]*:[^\s#]+")
LICENSE = re.compile(r"\(*[A-Za-z0-9.+-]+\)*( (AND|OR|WITH) \(*[A-Za-z0-9.+-]+\)*)*")
PURL = re.compile(r"pkg:[a-z]+/[^\s@]+(@\S+)?")
HASH_DIGITS = {"SHA1": 40, "SHA256": 64}
RELATIONS = {"DESCRIBES", "CONTAINS", "STATIC_LINK", "DEPENDS_ON"}  # those that make_sbom.py writes, of SPDX's 45
DOCUMENT = ("spdxVersion", "dataLicense", "SPDXID", "name", "documentNamespace", "creationInfo")
PACKAGE = ("SPDXID", "name", "downloadLocation")
FILE = ("SPDXID", "fileName", "checksums")


def missing(where, one, fields):
    return [f"{where}/{field}: is missing" for field in fields if not one.get(field)]


def form(where, text, pattern):
    return [] if isinstance(text, str) and pattern.fullmatch(text) else [f"{where}: is {text!r}"]


def checksum_problems(where, checksums):
    problems = []
    for one in checksums:
        digits = HASH_DIGITS.get(one.get("algorithm"), 0)
        if not re.fullmatch(f"[0-9a-f]{{{digits}}}", one.get("checksumValue", "")):
            problems.append(f"{where}/checksums: {one} is no hash")
    return problems


def document_problems(document):
    problems = missing("", document, DOCUMENT)
    if problems:
        return problems
    if document["spdxVersion"] != "SPDX-2.3" or document["dataLicense"] != "CC0-1.0":
        problems.append("/spdxVersion: must be SPDX-2.3, /dataLicense CC0-1.0")
    if document["SPDXID"] != "SPDXRef-DOCUMENT":
        problems.append("/SPDXID: must be SPDXRef-DOCUMENT")
    problems += form("/documentNamespace", document["documentNamespace"], NAMESPACE)
    problems += form("/creationInfo/created", document["creationInfo"].get("created"), TIME)
    creators = document["creationInfo"].get("creators", [])
    for creator in creators or [""]:
        problems += form("/creationInfo/creators", creator, CREATOR)
    return problems


def package_problems(where, package):
    problems = missing(where, package, PACKAGE) + checksum_problems(where, package.get("checksums", []))
    for field in ("licenseDeclared", "licenseConcluded"):
        problems += form(f"{where}/{field}", package.get(field, "NOASSERTION"), LICENSE)
    if package.get("filesAnalyzed", True):
        problems += missing(where, package, ("packageVerificationCode",))
    for reference in package.get("externalRefs", []):
        if reference.get("referenceType") == "purl":
            problems += form(f"{where}/externalRefs", reference.get("referenceLocator"), PURL)
    return problems


def file_problems(where, file):
    problems = missing(where, file, FILE) + checksum_problems(where, file.get("checksums", []))
    if "SHA1" not in {one.get("algorithm") for one in file.get("checksums", [])}:
        problems.append(f"{where}/checksums: has no SHA1")
    if not file.get("fileName", "").startswith("./"):
        problems.append(f"{where}/fileName: must begin with ./")
    return problems


def relation_problems(document, elements):
    problems = []
    relations = [
        (one.get("spdxElementId"), one.get("relationshipType"), one.get("relatedSpdxElement"))
        for one in document.get("relationships", [])
    ]
    for i, (a, relation, b) in enumerate(relations):
        if relation not in RELATIONS or a not in elements or b not in elements:
            problems.append(f"/relationships/{i}: {a} {relation} {b}: not between elements of this document")
    if not any((a, relation) == ("SPDXRef-DOCUMENT", "DESCRIBES") for a, relation, _ in relations):
        problems.append("/relationships: the document describes nothing")
    return problems


def rule_problems(document):
    problems = document_problems(document)
    elements = ["SPDXRef-DOCUMENT"]
    for kind, check in (("packages", package_problems), ("files", file_problems)):
        for i, one in enumerate(document.get(kind, [])):
            problems += check(f"/{kind}/{i}", one) + form(f"/{kind}/{i}/SPDXID", one.get("SPDXID"), IDENTIFIER)
            elements.append(one.get("SPDXID"))
    problems += [
        f"{one}: stands twice" for one in sorted({one for one in elements if elements.count(one) > 1}, key=str)
    ]
    return problems + relation_problems(document, set(elements))


def artefact_problems(document, artefact):
    """Whether it is the bill of this file."""
    (own, *_) = document["packages"]
    said = {one["algorithm"]: one["checksumValue"] for one in own.get("checksums", [])}
    if said.get("SHA256") != hashlib.sha256(artefact.read_bytes()).hexdigest():
        return [f"{artefact.name}: has another hash"]
    content = sbom_parts.content_of(artefact)
    told = {file["fileName"].removeprefix("./"): file["checksums"][0]["checksumValue"] for file in document["files"]}
    problems = [f"{name}: stands in one of the two alone" for name in sorted(set(told) ^ set(content))]
    problems += [
        f"{n}: has another hash" for n in sorted(set(told) & set(content)) if told[n] != sbom_parts.sha1(content[n])
    ]
    if own["packageVerificationCode"]["packageVerificationCodeValue"] != sbom_parts.verification_code(content.values()):
        problems.append(f"{artefact.name}: has another verification code")
    return problems


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    wrong = False
    for path in map(pathlib.Path, sys.argv[1:]):
        document = json.loads(path.read_text(encoding="utf-8"))
        problems = rule_problems(document)
        if not problems:
            problems = artefact_problems(document, path.with_name(path.name.removesuffix(".spdx.json")))
        for problem in problems:
            print(f"{path}: {problem}", file=sys.stderr)
        wrong = wrong or bool(problems)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
