"""Client of coapt-server: mitral valve repair in simulation.

    from coapt import Client, Plan, Ring

    client = Client("http://127.0.0.1:8080")
    print(client.close("human-functional-mr", Plan(Ring("generic-classic", size_mm=30))).measure.leak_mm2)
    result = client.search("human-functional-mr", evaluations=60, seed=1, plans=2, region_points=17, evidence=False).result()
    result.plans[0].picture().write("before-after.png")

Units are the last part of a name: mm, mm2, n (newtons), deg, s. coapt is research software, not a medical device; not for
clinical decisions.
"""

from .client import Client, RingShape, StoredValve, Valve
from .errors import (
    AccessDenied,
    Busy,
    CoaptError,
    Conflict,
    InvalidRequest,
    JobFailed,
    NotEnded,
    NotFound,
    Problem,
    Refused,
    ServiceFailed,
    Unreachable,
)
from .events import Event, Progress
from .jobs import Job, show_progress
from .meshes import Mesh, Picture
from .repair import (
    ChordalExcision,
    ChordalLengthChange,
    ChordalTransfer,
    LeafletPoint,
    Neochorda,
    OwnRing,
    PapillaryApproximation,
    Plan,
    Ring,
)
from .results import Before, Closure, Evaluations, Finding, Measure, RankedPlan, SearchResult, Statistics, StudyResult
from .tables import NOTICE

__version__ = "0.1.0"

__all__ = [
    "NOTICE",
    "AccessDenied",
    "Before",
    "Busy",
    "ChordalExcision",
    "ChordalLengthChange",
    "ChordalTransfer",
    "Client",
    "Closure",
    "CoaptError",
    "Conflict",
    "Evaluations",
    "Event",
    "Finding",
    "InvalidRequest",
    "Job",
    "JobFailed",
    "LeafletPoint",
    "Measure",
    "Mesh",
    "Neochorda",
    "NotEnded",
    "NotFound",
    "OwnRing",
    "PapillaryApproximation",
    "Picture",
    "Plan",
    "Problem",
    "Progress",
    "RankedPlan",
    "Refused",
    "Ring",
    "RingShape",
    "SearchResult",
    "ServiceFailed",
    "Statistics",
    "StoredValve",
    "StudyResult",
    "Unreachable",
    "Valve",
    "show_progress",
]
