#!/usr/bin/env python3
"""Writes the bill of materials of an artefact (wheel, tarball, Debian package) beside it: ARTEFACT.spdx.json, SPDX 2.3.

Usage: SOURCE_DATE_EPOCH=... make_sbom.py ARTEFACT...

In it: the artefact with each of its files and their hashes; the Debian packages of the libraries that came along, of headers that are
compiled in, and that a package depends on; the npm packages in the page. A licence is said where Debian's copyright file or
package-lock.json says it in words that are SPDX's. The same artefact gives the same bytes.
"""
import datetime
import hashlib
import json
import os
import pathlib
import re
import sys

import sbom_parts

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOCK = ROOT / "clients/web/package-lock.json"
NOTHING = {"licenseConcluded": "NOASSERTION", "copyrightText": "NOASSERTION"}


def hashes(content):
    return [
        {"algorithm": "SHA1", "checksumValue": sbom_parts.sha1(content)},
        {"algorithm": "SHA256", "checksumValue": hashlib.sha256(content).hexdigest()},
    ]


def identifier(kind, name):
    """Letters, figures, points and hyphens are all that SPDX takes; the hash tells apart what that makes equal."""
    return f"SPDXRef-{kind}-{re.sub(r'[^A-Za-z0-9.-]+', '-', name)}-{hashlib.sha256(name.encode()).hexdigest()[:8]}"


def name_and_version(artefact):
    """coapt-0.2.0-cp311-..., coapt-0.2.0-linux-x86_64.tar.gz, coapt-server_0.2.0_amd64.deb"""
    name, version = re.split(r"[-_](?=\d)", artefact.name, maxsplit=1)
    return name, re.match(r"[0-9][0-9.]*[0-9]", version)[0]


def parts_of(content):
    """Which of our code is in it."""
    names = {pathlib.PurePath(name).name for name in content}
    parts = set()
    if names & {"coapt", "coapt-server", "coapt-farm", "coapt-live"}:
        parts |= {"engine", "documents", "programs"}
    if "coapt-live" in names:
        parts.add("live")
    if any(name.startswith("_engine.cpython") for name in names):
        parts |= {"engine", "documents", "python"}
    if any(name.startswith("libcoapt.") for name in names):
        parts.add("engine")
    if "coapt-engine.wasm" in names:
        parts |= {"engine", "documents", "wasm"}
    if "furo.css" in names:
        parts.add("site")
    return parts


def components_of(artefact, content):
    found = sbom_parts.bundled_components(content) + sbom_parts.compiled_components(parts_of(content))
    found += sbom_parts.required_components(artefact)
    if any(re.search(r"assets/[^/]+\.js$", name) for name in content):
        found += sbom_parts.page_components(LOCK)
    return found


def package_of(component):
    return {
        "SPDXID": identifier("Package", component.url),
        "name": component.name,
        **({"versionInfo": component.version} if component.version else {}),
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseDeclared": component.license,
        **NOTHING,
        "externalRefs": [
            {"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": component.url}
        ],
    }


def document_of(artefact, made):
    """:param made: seconds since 1970"""
    content = dict(sorted(sbom_parts.content_of(artefact).items()))
    whole = artefact.read_bytes()
    name, version = name_and_version(artefact)
    own = identifier("Package", artefact.name)
    files = [
        {
            "SPDXID": identifier("File", f),
            "fileName": f"./{f}",
            "checksums": hashes(c),
            **NOTHING,
            "licenseInfoInFiles": ["NOASSERTION"],
        }
        for f, c in content.items()
    ]
    components = components_of(artefact, content)
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", own)] + [(own, "CONTAINS", file["SPDXID"]) for file in files]
    for one in components:
        package = identifier("Package", one.url)
        relations.append((own, one.relation, package))
        relations += [(package, "CONTAINS", identifier("File", file)) for file in one.files if file in content]
    return {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": artefact.name,
        "documentNamespace": f"urn:coapt:sbom:{artefact.name}:{hashlib.sha256(whole).hexdigest()}",
        "creationInfo": {
            "created": datetime.datetime.fromtimestamp(made, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
            "creators": ["Organization: The coapt authors", "Tool: coapt-make_sbom"],
        },
        "packages": [
            {
                "SPDXID": own,
                "name": name,
                "versionInfo": version,
                "packageFileName": artefact.name,
                "downloadLocation": "NOASSERTION",
                "filesAnalyzed": True,
                "packageVerificationCode": {
                    "packageVerificationCodeValue": sbom_parts.verification_code(content.values())
                },
                "checksums": hashes(whole),
                "licenseDeclared": "BSD-3-Clause",
                "licenseInfoFromFiles": ["NOASSERTION"],
                **NOTHING,
            },
            *({one["SPDXID"]: one for one in map(package_of, components)}.values()),
        ],
        "files": files,
        "relationships": [
            {"spdxElementId": a, "relationshipType": relation, "relatedSpdxElement": b} for a, relation, b in relations
        ],
    }


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if "SOURCE_DATE_EPOCH" not in os.environ:
        sys.exit("SOURCE_DATE_EPOCH is not set: the time of the commit, in seconds since 1970")
    for artefact in map(pathlib.Path, sys.argv[1:]):
        document = document_of(artefact, int(os.environ["SOURCE_DATE_EPOCH"]))
        written = artefact.with_name(f"{artefact.name}.spdx.json")
        written.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
        print(written)


if __name__ == "__main__":
    main()
