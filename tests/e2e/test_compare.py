"""`coapt compare`: closed shapes against references of several formats."""

import json
import struct
import unittest

from programs import BAD_INPUT, FAILURE, NOT_CLOSED, SOURCE, ProgramTest, coapt, small_valve


def grid(columns, rows, height, cell=1.0, x=0.0, y=0.0):
    """A flat OBJ sheet, normals up."""
    lines = [f"v {x + cell * i} {y + cell * j} {height}" for j in range(rows + 1) for i in range(columns + 1)]
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i + 1
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    return "\n".join(lines) + "\n"


class Compare(ProgramTest):
    def compare(self, *arguments):
        return json.loads(self.run_ok("compare", *arguments, "--json").stdout)

    def test_the_same_nodes_moved_lie_as_far_apart_as_they_were_moved(self):
        a, b = self.write("a.obj", grid(4, 3, 0)), self.write("b.obj", grid(4, 3, 0.4, x=0.3))
        found = self.compare(b, a)
        self.assertEqual((found["schema"], found["pairing"]), ("coapt.comparison/1", "node_to_node"))
        for key in ("rms_mm", "p95_mm", "max_mm"):
            self.assertAlmostEqual(found[key], 0.5, places=12)
        self.assertAlmostEqual(found["rms_after_rigid_mm"], 0, places=9)
        self.assertAlmostEqual(self.compare(b, a, "--align", "rigid")["max_mm"], 0, places=9)

    def test_a_sheet_above_another_mesh_is_measured_to_its_surface_with_its_sign(self):
        low = self.write("low.obj", grid(10, 10, 0))
        high, under = (self.write(f"{z}.obj", grid(3, 2, z, 1.5, 2, 2)) for z in (0.25, -0.25))
        found = self.compare(high, low, "--align", "none")
        self.assertEqual(found["pairing"], "node_to_surface")
        self.assertAlmostEqual(found["max_mm"], 0.25, places=12)
        self.assertAlmostEqual(found["mean_signed_mm"], 0.25, places=12)
        self.assertAlmostEqual(self.compare(under, low, "--align", "none")["mean_signed_mm"], -0.25, places=12)
        self.assertAlmostEqual(found["closed"]["area_mm2"], 13.5, places=9)
        self.assertEqual(found["closed"]["leaflets"][0]["name"], "piece 1")

    def test_two_sheets_in_contact_say_so_at_the_distance_asked_for(self):
        both = grid(20, 20, 0) + grid(20, 20, 1).replace("f ", "f -")
        # The second sheet's faces, relative to the last vertex.
        lines, count = [], 21 * 21
        for line in both.splitlines():
            if line.startswith("f -"):
                line = "f " + " ".join(str(abs(int(n)) + count) for n in line[2:].split())
            lines.append(line)
        file = self.write("both.obj", "\n".join(lines))
        self.assertEqual(self.compare(file, file, "--contact-mm", "0.9")["closed"]["contact_share"], 0)
        self.assertEqual(self.compare(file, file, "--contact-mm", "1.1")["closed"]["contact_share"], 1)

    def test_an_exported_closure_is_the_valve_that_was_closed(self):
        vtk, stl = self.folder / "closed.vtk", self.folder / "closed.stl"
        self.run_ok("export", "human-normal", "-o", vtk, "-o", stl)
        found = self.compare("human-normal", vtk)
        self.assertEqual(found["pairing"], "node_to_node")
        self.assertLess(found["max_mm"], 1e-6)
        self.assertEqual([leaflet["name"] for leaflet in found["closed"]["leaflets"]], ["anterior", "posterior"])
        self.assertEqual(found["closed"]["leaflets"][0]["name"], found["reference"]["leaflets"][0]["name"])
        for ours, theirs in zip(found["closed"]["leaflets"], found["reference"]["leaflets"]):
            self.assertAlmostEqual(ours["area_mm2"], theirs["area_mm2"], places=4)
        self.assertGreater(found["closed"]["contact_share"], 0.1)
        self.assertLess(self.compare(vtk, stl)["max_mm"], 1e-4)

    def test_a_finer_mesh_of_the_same_valve_is_aligned_and_near(self):
        fine = self.make("human-normal", "--triangles", "2600")
        found = self.compare("human-normal", fine)
        self.assertEqual(found["pairing"], "node_to_surface")
        self.assertTrue(found["alignment"]["rigid"] and found["alignment"]["settled"])
        self.assertLess(found["alignment"]["rotation_deg"], 5)
        self.assertLess(found["rms_mm"], 1)

    def test_a_valve_is_repaired_and_closed_as_close_does_it(self):
        plan, valve = SOURCE / "examples/plans/ring.json", "human-functional-mr"
        repaired = ("--plan", plan, "--pressure", "100", "--membrane", "springs")
        mesh = self.folder / "repaired.ply"
        self.run_ok("close", valve, *repaired, "--closed", mesh)
        self.assertLess(self.compare(valve, mesh, *repaired)["max_mm"], 1e-3)
        self.assertGreater(self.compare(valve, mesh)["max_mm"], 0.5)
        self.assertGreater(self.compare(valve, valve, "--plan", plan)["max_mm"], 0.5)
        fine = self.compare(valve, mesh, "--certainty", "sure")
        self.assertGreater(fine["closed"]["nodes"], 3 * fine["reference"]["nodes"])
        self.refused("is a surface; a repair, pressure and tissue", mesh, valve, "--plan", plan)
        self.refused("--method: is about closing a valve", mesh, mesh, "--method", "thesis")
        self.refused("--pressure", valve, mesh, "--pressure", "0")
        self.refused("--accuracy", valve, mesh, "--accuracy", "1", "--converge")

    def test_map_and_mesh_are_written(self):
        a, b = self.write("a.obj", grid(4, 3, 0)), self.write("b.obj", grid(4, 3, 0.4))
        picture, mesh = self.folder / "map.png", self.folder / "map.vtk"
        said = self.run_ok("compare", b, a, "--map", picture, "-o", mesh).stdout
        self.assertIn("rms 0.400 mm, p95 0.400 mm, max 0.400 mm", said)
        header = picture.read_bytes()[:24]
        self.assertEqual(header[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", header[16:]), (2200, 1280))
        self.assertIn("SCALARS signed_distance_mm double 1\nLOOKUP_TABLE default\n0.4\n", mesh.read_text())

    def test_files_of_a_closure_that_is_not_to_be_trusted_say_so(self):
        valve = json.loads(small_valve().read_text())
        valve["tissue"]["thickness_mm"] = 0.1  # its leaflets pass through each other
        thin, mesh = self.write("thin.json", valve), self.folder / "map.vtk"
        run = coapt("compare", thin, small_valve(), "-o", mesh)
        self.assertEqual(run.returncode, NOT_CLOSED, run.stderr)
        self.assertTrue(mesh.read_text().split("\n")[1].endswith("; closed: UNRELIABLE: leaflets cross"))
        coapt("compare", small_valve(), thin, "-o", mesh)
        self.assertTrue(mesh.read_text().split("\n")[1].endswith("; reference: UNRELIABLE: leaflets cross"))

    def test_leaflets_are_those_of_the_array_asked_for(self):
        vtu = self.write("two.vtu", VTU)
        found = self.compare(vtu, vtu, "--leaflets", "parts")
        self.assertEqual([leaflet["name"] for leaflet in found["closed"]["leaflets"]], ["parts 3", "parts 5"])
        self.assertEqual([leaflet["area_mm2"] for leaflet in found["closed"]["leaflets"]], [1, 0.5])
        moved = self.compare(
            vtu,
            self.write("open.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0.5 0\nf 1 2 3 4\nf 2 5 3\n"),
            "--displacement",
            "U",
        )
        self.assertAlmostEqual(moved["rms_mm"], 2, places=12)
        self.refused("has no array 'no'", vtu, vtu, "--leaflets", "no")
        self.refused("has no array 'no' with three numbers per point; available: U", vtu, vtu, "--displacement", "no")

    def refused(self, words, *arguments):
        result = coapt("compare", *arguments)
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""), result.stderr)
        self.assertIn(words, result.stderr)

    def test_bad_input_is_named(self):
        good = self.write("a.obj", grid(4, 3, 0))
        self.refused("no.stl: cannot be opened", good, self.folder / "no.stl")
        self.refused("no such file, and not a preset", good, "human-norma")
        self.refused("must end in one of obj, ply, stl, vtk, vtp, vtu", self.write("a.txt", ""), good)
        self.refused("is not a VTK XML file", self.write("a.vtu", "nothing"), good)
        self.refused("/faces: is empty", self.write("b.obj", "v 0 0 0\n"), good)
        self.refused("--align", good, good, "--align", "affine")
        result = coapt("compare", good, good, "--map", self.folder / "no/such/map.png")
        self.assertEqual(result.returncode, FAILURE)


VTU = """<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece>
<PointData><DataArray type="Float64" Name="U" NumberOfComponents="3" format="ascii">
0 0 2 0 0 2 0 0 2 0 0 2 0 0 2</DataArray></PointData>
<CellData><DataArray type="Int32" Name="parts" format="ascii">3 5</DataArray></CellData>
<Points><DataArray type="Float32" format="ascii">0 0 0 1 0 0 1 1 0 0 1 0 2 0.5 0</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3 1 4 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4 7</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">9 5</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
"""

if __name__ == "__main__":
    unittest.main()
