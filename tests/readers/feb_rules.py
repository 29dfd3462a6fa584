"""The rules of FEBio's format 4.0 that a model can break without being ill-formed XML: what refers to what, and the
sections and their order (FEBio user's manual, chapter 3). This is not FEBio."""

import xml.etree.ElementTree as ET

SECTIONS = [
    "Module",
    "Control",
    "Material",
    "Mesh",
    "MeshDomains",
    "MeshData",
    "Boundary",
    "Loads",
    "Contact",
    "Discrete",
    "LoadData",
    "Output",
]
BC_TYPES = {"zero displacement", "prescribed displacement"}


def problems_of(path):
    try:
        root = ET.parse(path).getroot()
    except ET.ParseError as error:
        return [f"is no XML: {error}"]
    problems = []

    def expect(holds, message):
        if not holds:
            problems.append(message)

    expect(root.tag == "febio_spec" and root.get("version") == "4.0", "is no febio_spec 4.0")
    expect([section.tag for section in root] == SECTIONS, "sections are not those of a model, in order")
    if problems:
        return problems
    mesh = root.find("Mesh")
    nodes = [int(node.get("id")) for node in mesh.iter("node")]
    known = set(nodes)
    expect(nodes == sorted(known), "ids of nodes do not ascend")
    for node in mesh.iter("node"):
        expect(len([float(x) for x in node.text.split(",")]) == 3, "a node has not three coordinates")
    for tag, corners in [("elem", 3), ("tri3", 3), ("delem", 2)]:
        for element in mesh.iter(tag):
            ids = [int(i) for i in element.text.split(",")]
            expect(len(set(ids)) == corners and set(ids) <= known, f"{tag} {element.attrib} names no {corners} nodes")
    sets = {}
    for tag in ("Elements", "NodeSet", "Surface", "SurfacePair", "DiscreteSet"):
        sets[tag] = [one.get("name") for one in mesh.findall(tag)]
        expect(len(set(sets[tag])) == len(sets[tag]), f"a name of {tag} comes twice")
    for one in mesh.findall("NodeSet"):
        expect({int(i) for i in one.text.split(",")} <= known, f"set {one.get('name')} names nodes that are not there")
    for pair in mesh.findall("SurfacePair"):
        expect({side.text for side in pair} <= set(sets["Surface"]), "a pair names surfaces that are not there")

    materials = {one.get("name") for one in root.find("Material")}
    for domain in root.find("MeshDomains"):
        expect(domain.get("name") in sets["Elements"] and domain.get("mat") in materials, "a domain refers to nothing")
    for data in root.find("MeshData"):
        elements = mesh.find(f"Elements[@name='{data.get('elem_set')}']")
        expect([int(e.get("lid")) for e in data] == list(range(1, len(elements) + 1)), "axes are not one an element")
    curves = {one.get("id") for one in root.find("LoadData")}
    for one in root.iter():
        expect(one.get("lc") is None or one.get("lc") in curves, f"{one.tag} follows a curve that is not there")
    for bc in root.find("Boundary"):
        expect(
            bc.get("node_set") in sets["NodeSet"] and bc.get("type") in BC_TYPES,
            f"bc {bc.get('name')} refers to nothing",
        )
    for load in root.find("Loads"):
        expect(load.get("surface") in sets["Surface"], "a load refers to no surface")
    for contact in root.find("Contact"):
        expect(contact.get("surface_pair") in sets["SurfacePair"], "a contact refers to no pair")
    discrete = root.find("Discrete")
    springs = [one.get("id") for one in discrete.findall("discrete_material")]
    used = [(one.get("dmat"), one.get("discrete_set")) for one in discrete.findall("discrete")]
    expect(springs == [str(i + 1) for i in range(len(springs))], "ids of springs do not count from 1")
    expect(
        [mat for mat, _ in used] == springs and {s for _, s in used} == set(sets["DiscreteSet"]),
        "springs, their materials and sets do not match",
    )
    held = {i for one in mesh.findall("NodeSet") for i in one.text.split(",")}
    expect(len(held) > 0, "nothing is held")
    return problems
