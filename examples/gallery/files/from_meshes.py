"""Makes a valve of two leaflet meshes, an annulus and chordae, as segmented from real anatomy, and closes it."""

import coapt

folder = "examples/valves/source/bodyparts3d"
leaflets = [f"{folder}/{name}_leaflet_sheet.obj" for name in ("anterior", "posterior")]
engine = coapt.engine()
job = engine.import_job(leaflets, f"{folder}/annulus_centerline.csv", f"{folder}/chordae.csv", name="real")
made = job.result()
for one in made.decisions[:6]:
    print(f"{one.subject}: {one.value} ({one.reason})")
closure = engine.close(made.valve)
print(f"leak {closure.measure.leak_mm2:.1f} mm², {closure.status}")
made.picture().write("from_meshes.png")
