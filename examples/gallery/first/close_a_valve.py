"""Closes a valve with functional regurgitation and draws it from the atrium and in section, its leak in blue."""

import coapt

valve = coapt.preset("human-functional-mr")
closure = valve.close()
leak = closure.measure.leak
print(f"{closure.status}, leak {leak.area_mm2:.0f} ± {leak.error_mm2:.0f} mm² in {len(leak.openings)} opening(s)")
print(f"coaptation {closure.measure.coaptation_height_mean_mm:.1f} mm in the mean")
valve.picture().write("close_a_valve.png")
