"""The stages of the chain: what each needs, and which parts of the specification it depends on."""

from __future__ import annotations

from design.build.slicing import has_slicer
from instobj.stages.makers.alternatives import make_alternatives
from instobj.stages.makers.collection import make_collection
from instobj.stages.makers.deformation import make_large_strain, make_shapes
from instobj.stages.makers.fabrication import make_fabrication, make_sheet
from instobj.stages.makers.inversion import (
    make_contact_metrics,
    make_inversion,
    tangential_mechanics,
)
from instobj.stages.makers.magnet_free import (
    make_candidates,
    make_compliance,
    make_plain_mesh,
    make_plain_presses,
    make_plain_response,
    make_second_fidelity,
)
from instobj.stages.makers.mechanics import (
    make_build,
    make_coarse_response,
    make_discretisation,
    make_mesh,
    make_presses,
    make_response,
    make_shear,
)
from instobj.stages.makers.report import (
    make_press_curves,
    make_report,
    make_surroundings,
)
from instobj.stages.makers.scene import make_scene
from instobj.stages.makers.signals import (
    make_frames,
    make_identify,
    make_metrics,
    make_networks,
    make_robustness,
    make_scores,
    make_shear_scores,
    make_signals,
    make_weak_areas,
)
from instobj.stages.makers.slip import make_slip, objects_compared
from instobj.store.stage import Stage

_WHERE_THINGS_ARE = ("body", "shell", "magnets", "arrangement")
_MAKING = (
    *(*_WHERE_THINGS_ARE, "core", "sensors", "indenter"),
    *("mould", "printer", "mesh.envelope_mm"),
    *("contact_grid", "press"),  # the jig lifts the object as far as probes come down
)
_SHAPE = ("body", "shell.thickness_mm", "shell.slits", "core.keys")
_WHAT_IS_MESHED = (*_SHAPE, "shell_bodies", "mesh")
_ELASTIC = (
    "silicone.youngs_modulus_mpa",
    "silicone.poisson_ratio",
    "silicone.layers",
    "mechanics.element",
    "mechanics.interface",
    "mechanics.slip.rim",
)
_NUISANCES = ("limits.use", "tolerances.earth_field_ut", "tolerances.temperature_k")
"""Keys that `estimator.signals.nuisances` reads next to the signals' own keys."""
_PRESSED = ("contact_grid", "indenter", "press", "dents")

STAGES: dict[str, Stage] = {
    "build": Stage(
        "design: solids, mould and probes",
        (),
        ("name", *_MAKING),
        make_build,
        version=23,
    ),
    "sheet": Stage(
        "design: order list and assembly sheet",
        ("build",),
        ("name", *_MAKING, "silicone", "load_cell", "imu"),
        make_sheet,
        # the sheet has time and filament where a slicer is installed: another result
        version=18 + has_slicer(),
    ),
    "fabrication": Stage(
        "design: fabrication checks",
        (),
        ("name", *_MAKING, "silicone"),
        make_fabrication,
        version=19,
    ),
    "mesh": Stage("mesh: tetrahedra", (), _WHAT_IS_MESHED, make_mesh, version=5),
    "response": Stage(
        "mechanics: response operator", ("mesh",), _ELASTIC, make_response, version=2
    ),
    "large_strain": Stage(
        "mechanics: presses with large deformation",
        (),
        (
            *_WHAT_IS_MESHED,
            *_ELASTIC,
            "magnets.positions_mm",
            "contact_grid",
            "indenter",
            "press",
            "mechanics.correction",
        ),
        make_large_strain,
        version=5,
    ),
    "shapes": Stage(
        "mechanics: shapes of presses",
        ("mesh", "response"),
        _PRESSED,
        make_shapes,
        version=5,
    ),
    "presses": Stage(
        "mechanics: contact at every location and depth",
        ("mesh", "response", "large_strain"),
        (*_PRESSED, "mechanics.slip"),
        make_presses,
        version=7,
    ),
    "plain_mesh": Stage("mesh: without magnets", (), (*_SHAPE, "mesh"), make_plain_mesh, version=5),
    "plain_response": Stage(
        "mechanics: response without magnets",
        ("plain_mesh",),
        _ELASTIC,
        make_plain_response,
        version=2,
    ),
    "plain_presses": Stage(
        "mechanics: contact without magnets",
        ("plain_response",),
        ("contact_grid", "indenter", "press"),
        make_plain_presses,
        version=5,
    ),
    "compliance": Stage(
        "mechanics: compliance map",
        ("presses", "plain_presses"),
        ("magnets", "sensors", "arrangement"),
        make_compliance,
        version=2,
    ),
    "candidates": Stage(
        "mechanics: motions of candidate magnets",
        ("plain_mesh", "plain_response"),
        (
            "contact_grid",
            "indenter",
            "press",
            *("score.force_n", "search.forces_n"),
            "shell.pocket_diameter_mm",
            "shell_body_cylinder",
        ),
        make_candidates,
        version=15,
    ),
    "second_fidelity": Stage(
        "search: second fidelity level",
        ("plain_mesh", "plain_response"),
        (
            *(*_WHERE_THINGS_ARE, "core", "sensors", "environment", "as_built", "silicone"),
            *(*_PRESSED, "mechanics", "score", "limits.use", "tolerances", "seed"),
            *("search.forces_n", "limits.position_bound_mm"),
        ),
        make_second_fidelity,
        version=9,
    ),
    "coarse_response": Stage(
        "mechanics: response on a coarser mesh",
        (),
        (*_WHAT_IS_MESHED, *_ELASTIC),
        make_coarse_response,
        version=2,
    ),
    "discretisation": Stage(
        "mechanics: discretisation error",
        ("response", "coarse_response"),
        _PRESSED,
        make_discretisation,
        version=5,
    ),
    "signals": Stage(
        "signals: Hall sensors",
        ("presses",),
        ("magnets", "sensors", "arrangement", "environment", "as_built", "seed"),
        make_signals,
        version=4,
    ),
    "scores": Stage(
        "sensitivity: bounds and maps",
        ("signals",),
        ("score", *_NUISANCES, "seed"),
        make_scores,
        version=13,
    ),
    "weak_areas": Stage(
        "sensitivity: weak areas",
        ("scores",),
        ("limits.position_bound_mm",),
        make_weak_areas,
        version=9,
    ),
    "shear": Stage(
        "mechanics: tangential forces",
        ("mesh", "response"),
        (*_PRESSED, "mechanics.slip"),
        make_shear,
        version=3,
    ),
    "shear_scores": Stage(
        "sensitivity: with tangential forces",
        ("presses", "signals", "shear"),
        ("score", *_NUISANCES),
        make_shear_scores,
        version=4,
    ),
    "identify": Stage(
        "sensitivity: several simultaneous contacts",
        ("presses", "signals"),
        ("score", "limits.position_bound_mm", *_NUISANCES, "seed"),
        make_identify,
        version=6,
    ),
    "robustness": Stage(
        "robustness: tolerances",
        ("presses",),
        (
            *("magnets", "sensors", "arrangement", "environment", "as_built"),
            *("score.force_n", "score.channels", "limits.use", "tolerances", "seed"),
        ),
        make_robustness,
        version=5,
    ),
    "frames": Stage(
        "estimator: simulated presses",
        ("signals",),
        ("protocol", "silicone.prony", "seed"),
        make_frames,
        version=3,
    ),
    "collection": Stage(
        "estimator: simulated recordings",
        ("response", "large_strain", "signals"),
        ("collection", "protocol", "silicone.prony", "seed"),
        make_collection,
        version=2,
    ),
    "pulled_collection": Stage(
        "estimator: simulated recordings with tangential forces",
        ("response", "large_strain", "presses", "signals", "shear"),
        ("collection", "protocol", "silicone.prony", "seed"),
        make_collection,
        version=2,
    ),
    "networks": Stage(
        "estimator: training",
        ("frames",),
        ("training", *_NUISANCES, "seed"),
        make_networks,
        version=15,
    ),
    "metrics": Stage(
        "estimator: held-out presses", ("frames", "networks"), (), make_metrics, version=6
    ),
    "inversion": Stage(
        "estimator: tables of the forward model",
        ("response", "presses", "signals"),
        (
            *(*_WHERE_THINGS_ARE, "core", "sensors", "environment", "as_built", "mechanics"),
            *("indenter", "inversion", "limits.use", "tolerances", "seed"),
        ),
        make_inversion,
        version=8,
        of_others=tangential_mechanics,
    ),
    "contact_metrics": Stage(
        "estimator: contacts of a virtual object",
        ("response", "large_strain", "presses", "inversion"),
        ("collection", "protocol", "silicone.prony", "limits.use", "tolerances", "seed"),
        make_contact_metrics,
        version=17,
        of_others=tangential_mechanics,
    ),
    "surroundings": Stage(
        "signals: surroundings at rest",
        ("response", "signals"),
        (
            *(*_WHERE_THINGS_ARE, "core", "sensors", "environment", "as_built", "mechanics.slip"),
            *("score.channels", "score.force_n", "dents", *_ELASTIC, *_NUISANCES),
        ),
        make_surroundings,
        version=6,
    ),
    "press_curves": Stage(
        "signals: curves of presses, compliance",
        ("presses", "signals"),
        ("magnets", "sensors", "arrangement", "silicone", "protocol.peak_force_n"),
        make_press_curves,
        version=3,
    ),
    "alternatives": Stage(
        "sensitivity: what to try next",
        ("presses", "signals"),
        (
            *(*_MAKING, "silicone", "score", "seed", "mechanics", "contact_grid", "press"),
            *("environment", "as_built", "limits", "tolerances"),
        ),
        make_alternatives,
        version=15,
    ),
    "slip": Stage(
        "sensitivity: cost of the core's slip",
        (),
        ("name", "mechanics.slip", "score"),
        make_slip,
        version=4,
        of_others=objects_compared,
    ),
    "scene": Stage(
        "report: the object in three dimensions",
        ("build", "mesh", "response", "presses", "signals", "scores", "discretisation"),
        ("name", *_MAKING, "contact_grid", "press", "score", "as_built"),
        make_scene,
    ),
    "report": Stage(
        "report",
        (
            "build",
            "mesh",
            "response",
            "shapes",
            "presses",
            "large_strain",
            "discretisation",
            "signals",
            "scores",
            "weak_areas",
            "frames",
            "robustness",
            "contact_metrics",
            "surroundings",
            "press_curves",
            "alternatives",
            "slip",
            "scene",
        ),
        ("name", "limits", "silicone"),
        make_report,
        version=30,
    ),
}
"""Stages in the order in which a command works through the ones that it needs."""
