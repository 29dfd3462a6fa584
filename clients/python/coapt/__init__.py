"""Client of coapt-server: mitral valve repair in simulation.

    from coapt import Client, Plan, Ring

    client = Client("http://127.0.0.1:8080")
    print(client.close("human-functional-mr", Plan(Ring("generic-classic", size_mm=36))).measure.leak_mm2)
    result = client.search("human-functional-mr", evaluations=60, seed=1, plans=2, region_points=65).result()
    result.plans[0].picture().write("before-after.png")

Units are the last part of a name: mm, mm2, n (newtons), deg, s. coapt is research software, not a medical device; not for
clinical decisions.
"""

from .client import Client
from .errors import (
    AccessDenied,
    BadDocument,
    Busy,
    CoaptError,
    Conflict,
    InvalidRequest,
    JobFailed,
    MissingPackage,
    NoSuchFile,
    NotEnded,
    NotFound,
    Problem,
    Refused,
    ServiceFailed,
    Unreachable,
)
from .events import Event, LeadingPlan, Progress
from .evidence import Coaptation, LeakMap, LeakMaps, Remodelling, Section, Table
from .fits import Fit, FitResult, FittedParameter, ImportResult
from .jobs import Job, show_progress
from .meshes import Mesh, Picture
from .openings import Opening
from .repair import (
    ChordalExcision,
    ChordalLengthChange,
    ChordalTransfer,
    DesignedRing,
    EdgeToEdge,
    LeafletPoint,
    NamedPlan,
    Neochorda,
    OwnRing,
    PapillaryApproximation,
    QuadrangularResection,
    TriangularResection,
    Plan,
    Ring,
    read_plans,
)
from .results import Before, Closure, Evaluations, Finding, Measure, RankedPlan, SearchResult, Statistics, StudyResult
from .sources import PlanSource, Valve
from .stored import ImportDecision, KeptPlan, RingShape, StoredValve
from .sweep import Sweep, SweepItem
from .tables import NOTICE

__version__ = "0.1.0"

__all__ = [
    "NOTICE",
    "AccessDenied",
    "BadDocument",
    "Before",
    "Busy",
    "ChordalExcision",
    "ChordalLengthChange",
    "ChordalTransfer",
    "DesignedRing",
    "EdgeToEdge",
    "Client",
    "Closure",
    "CoaptError",
    "Coaptation",
    "Conflict",
    "Evaluations",
    "Event",
    "Finding",
    "Fit",
    "FitResult",
    "FittedParameter",
    "InvalidRequest",
    "Job",
    "JobFailed",
    "ImportDecision",
    "ImportResult",
    "KeptPlan",
    "LeadingPlan",
    "LeafletPoint",
    "LeakMap",
    "LeakMaps",
    "Measure",
    "Mesh",
    "MissingPackage",
    "NamedPlan",
    "Neochorda",
    "NoSuchFile",
    "NotEnded",
    "NotFound",
    "Opening",
    "OwnRing",
    "PapillaryApproximation",
    "QuadrangularResection",
    "TriangularResection",
    "Picture",
    "Plan",
    "PlanSource",
    "Problem",
    "Progress",
    "RankedPlan",
    "Refused",
    "Remodelling",
    "Ring",
    "RingShape",
    "SearchResult",
    "Section",
    "ServiceFailed",
    "Statistics",
    "StoredValve",
    "StudyResult",
    "Sweep",
    "SweepItem",
    "Table",
    "Unreachable",
    "Valve",
    "read_plans",
    "show_progress",
]
