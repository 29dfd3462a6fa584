"""The bill of materials of an archive, and what its check finds."""

import copy
import io
import json
import pathlib
import sys
import tarfile
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cmake/packaging"))

from check_sbom import artefact_problems, rule_problems  # noqa: E402
from make_sbom import document_of, name_and_version  # noqa: E402

FILES = {
    "coapt-1.2/bin/coapt": b"a program",
    "coapt-1.2/lib/coapt/libz.so.1": b"a library",
    "coapt-1.2/lib/coapt/libraries.tsv": b"libz.so.1\tzlib1g\t1:1.2.13.dfsg-1+b1\tamd64\n",
    "coapt-1.2/share/coapt/web/assets/page.js": b"the page",
}
MADE = 1_700_000_000


class Bill(unittest.TestCase):
    def setUp(self):
        self.enterContext(folder := tempfile.TemporaryDirectory())
        self.archive = pathlib.Path(folder.name) / "coapt-1.2-linux-x86_64.tar.gz"
        self.write(FILES)
        self.document = document_of(self.archive, MADE)

    def write(self, files):
        with tarfile.open(self.archive, "w:gz") as archive:
            for name, content in files.items():
                entry = tarfile.TarInfo(name)
                entry.size = len(content)
                archive.addfile(entry, io.BytesIO(content))

    def packages(self):
        return {package["name"]: package for package in self.document["packages"]}

    def test_files_libraries_headers_and_npm_packages_are_in_it(self):
        self.assertEqual([file["fileName"] for file in self.document["files"]], [f"./{name}" for name in sorted(FILES)])
        packages = self.packages()
        self.assertEqual(packages["coapt"]["versionInfo"], "1.2")
        (reference,) = packages["zlib1g"]["externalRefs"]
        self.assertEqual(reference["referenceLocator"], "pkg:deb/debian/zlib1g@1:1.2.13.dfsg-1%2Bb1?arch=amd64")
        self.assertLessEqual({"libeigen3-dev", "three", "uplot"}, packages.keys())
        self.assertEqual(packages["three"]["licenseDeclared"], "MIT")
        self.assertNotIn("vite", packages)
        kinds = {
            (one["relationshipType"], one["relatedSpdxElement"].split("-")[1]) for one in self.document["relationships"]
        }
        self.assertEqual(
            kinds,
            {("DESCRIBES", "Package"), ("CONTAINS", "File"), ("CONTAINS", "Package"), ("STATIC_LINK", "Package")},
        )

    def test_it_keeps_the_rules_and_is_that_of_its_archive(self):
        self.assertEqual(rule_problems(self.document), [])
        self.assertEqual(artefact_problems(self.document, self.archive), [])
        self.assertEqual(document_of(self.archive, MADE), self.document)
        self.assertEqual(self.document["creationInfo"]["created"], "2023-11-14T22:13:20Z")
        json.dumps(self.document)

    def test_another_archive_is_noticed(self):
        self.write(FILES | {"coapt-1.2/bin/coapt": b"another program"})
        (problem,) = artefact_problems(self.document, self.archive)
        self.assertIn("another hash", problem)

    def test_each_broken_rule_is_told_with_its_place(self):
        def broken(change):
            document = copy.deepcopy(self.document)
            change(document)
            return rule_problems(document)

        for place, change in (
            ("/name", lambda d: d.pop("name")),
            ("/spdxVersion", lambda d: d.update(spdxVersion="SPDX-2.2")),
            ("/documentNamespace", lambda d: d.update(documentNamespace="urn:coapt#1")),
            ("/creationInfo/created", lambda d: d["creationInfo"].update(created="2023-11-14")),
            ("/creationInfo/creators", lambda d: d["creationInfo"].update(creators=["me"])),
            ("/packages/0/packageVerificationCode", lambda d: d["packages"][0].pop("packageVerificationCode")),
            ("/packages/1/downloadLocation", lambda d: d["packages"][1].pop("downloadLocation")),
            ("/packages/1/licenseDeclared", lambda d: d["packages"][1].update(licenseDeclared="see file")),
            ("/files/0/checksums", lambda d: d["files"][0]["checksums"].pop(0)),
            ("/files/1/checksums", lambda d: d["files"][1]["checksums"][0].update(checksumValue="0")),
            ("/files/2/fileName", lambda d: d["files"][2].update(fileName="bin/coapt")),
            ("/relationships/3", lambda d: d["relationships"][3].update(relatedSpdxElement="SPDXRef-none")),
            ("/relationships", lambda d: d["relationships"].pop(0)),
        ):
            problems = broken(change)
            self.assertTrue(problems and problems[0].startswith(place), (place, problems))

    def test_names_of_all_kinds_of_artefacts_are_read(self):
        for name, told in (
            ("coapt-0.2.0-cp311-cp311-manylinux_2_36_x86_64.whl", ("coapt", "0.2.0")),
            ("coapt-0.2.0-linux-x86_64.tar.gz", ("coapt", "0.2.0")),
            ("python3-coapt_0.2.0_amd64.deb", ("python3-coapt", "0.2.0")),
            ("libcoapt-dev_0.2.0-1_amd64.deb", ("libcoapt-dev", "0.2.0")),
        ):
            self.assertEqual(name_and_version(pathlib.Path(name)), told)


if __name__ == "__main__":
    unittest.main()
