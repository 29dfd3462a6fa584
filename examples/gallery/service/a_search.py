"""Starts a search in a service, follows its events, and draws the valve before and after the plan that it found."""

from coapt import Client

client = Client()  # the service that COAPT_SERVER names
options = {"evaluations": 60, "seed": 1, "plans": 1, "region_points": 5, "model_draws": 0, "fine_levels": 0}
job = client.search("human-functional-mr", evidence=False, openings=False, **options)
for event in job.events():
    print(event)
best = job.result().plans[0]
print(*best.description, sep="\n")
best.picture().write("a_search.png")
