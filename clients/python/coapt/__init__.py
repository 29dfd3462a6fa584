"""Mitral valve repair in simulation, in this process or by a coapt-server.

>>> import coapt
>>> from coapt import OwnRing, PapillaryApproximation, Plan, Ring, plots
>>> valve = coapt.preset("human-functional-mr")
>>> plan = Plan(Ring("generic-classic", size_mm=32))
>>> closure = valve.close(plan)
>>> closure.measure.leak_mm2 < valve.close().measure.leak_mm2
True
>>> space = valve.space()
>>> client = coapt.engine()  # or coapt.Client("http://127.0.0.1:8080"): the same functions
>>> job = client.search("human-functional-mr", evaluations=20, plans=1, region_points=17)
>>> result = job.result()
>>> best = result.plans[0]

The examples below go on from here. Units are the last part of a name: mm, mm2, n (newtons), deg, s. coapt is research software,
not a medical device; not for clinical decisions.
"""

import pkgutil

# The engine is built into a folder of its own: build/release/python.
__path__ = pkgutil.extend_path(__path__, __name__)

from .client import Client
from .closures import Closure, Measure
from .comparison import Comparison
from .engine import Engine, LocalValve
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
from .estimates import Estimate
from .events import Event, LeadingPlan, Progress
from .evidence import Coaptation, LeakMap, LeakMaps, Remodelling, Section, Table, Tolerance
from .fits import Fit, FitResult, FittedParameter, ImportResult
from .jobs import Job, show_progress
from .leaks import Leak, LeakOpening
from .local import close_many, engine, preset, read_valve
from .meshes import Mesh, Picture
from .openings import Opening
from .ordering import Merits, Ordered, order_plans
from .ranked_plans import RankedPlan, Statistics
from .repair import NamedPlan, Plan, read_plans
from .results import Before, Evaluations, Finding, SearchResult, StudyResult
from .searchers import Searcher
from .service import Service
from .sources import PlanSource, Valve
from .spaces import Space, Trial
from .steps import (
    ChordalExcision,
    ChordalLengthChange,
    ChordalTransfer,
    DesignedRing,
    EdgeToEdge,
    LeafletPoint,
    Neochorda,
    OwnRing,
    PapillaryApproximation,
    QuadrangularResection,
    Ring,
    TriangularResection,
)
from .stored import ImportDecision, KeptPlan, RingShape, StoredValve
from .sweep import Sweep, SweepItem
from .tables import NOTICE

__version__ = "0.2.0"

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
    "Comparison",
    "Conflict",
    "Engine",
    "Estimate",
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
    "Leak",
    "LeakMap",
    "LeakOpening",
    "LocalValve",
    "LeakMaps",
    "Measure",
    "Merits",
    "Mesh",
    "MissingPackage",
    "NamedPlan",
    "Neochorda",
    "NoSuchFile",
    "NotEnded",
    "NotFound",
    "Opening",
    "Ordered",
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
    "Searcher",
    "Section",
    "Service",
    "ServiceFailed",
    "Space",
    "Statistics",
    "StoredValve",
    "StudyResult",
    "Sweep",
    "SweepItem",
    "Table",
    "Tolerance",
    "Trial",
    "Unreachable",
    "Valve",
    "close_many",
    "engine",
    "order_plans",
    "preset",
    "read_plans",
    "read_valve",
    "show_progress",
]
