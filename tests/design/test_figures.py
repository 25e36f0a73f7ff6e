"""Figures of parts, moulds, checks and proposals that were chosen or measured, in one table.

Nothing but their choice makes them right; each is told in its docstring or on a page. Left out are
numbers of samples that are high enough, tolerances far below what is printed, and colours.
"""

import numpy as np
import pytest

import design.body.foreign
import design.body.imported
import design.body.kinds.base
import design.body.meshes
import design.body.sampled
import design.body.section_lengths
import design.body.surface_chart
import design.build.bom
import design.build.order_list
import design.build.print_settings
import design.catalogue.bus_parts
import design.catalogue.magnets
import design.catalogue.orders
import design.catalogue.silicones
import design.catalogue.tensile
import design.catalogue.tensile_files
import design.fabrication.assembly
import design.fabrication.casting
import design.fabrication.check
import design.fabrication.printing
import design.fit.boards
import design.fit.curved
import design.fit.magnet_places
import design.fit.nearest
import design.layout.blocks
import design.layout.boards
import design.layout.core_hold
import design.layout.core_sockets
import design.layout.mould.closure
import design.layout.mould.frame
import design.layout.mould.pins
import design.layout.mould.pouring
import design.layout.places.contact_places
import design.layout.places.coverage
import design.layout.places.measures
import design.layout.surface
import design.layout.template_marks
import design.layout.tips
import design.mould.flange
import design.mould.halves
import design.mould.openings
import design.mould.plug_flange
import design.netcdf
import design.placement.asked
import design.placement.hooking
import design.placement.objects
import design.placement.paths
import design.placement.patterns
import design.placement.room
import design.search.faces
import design.solids.booleans
import design.solids.curved_template
import design.solids.foreign
import design.solids.jig
import design.solids.magnet_template
import design.solids.primitives
import design.solids.probes
import design.solids.sampled
import design.spec.body
import design.spec.learning
import design.spec.load_cell
import design.spec.object
import design.spec_io
import design.wiring.bus_limits
import design.wiring.bus_plan
import design.wiring.dealing
import design.wiring.lengths
import design.wiring.load_cell
import design.wiring.wires
from design.placement.objects import Trim

FIGURES = {
    design.body.foreign: {"SECONDS": 180.0, "MEMORY_GIB": 8.0},
    design.body.imported: {"_PIERCED_MM": 0.1},
    design.body.kinds.base: {"OVERSHOOT_MM": 1.0, "ALL_FACES": (1, 2, 3, 4, 5, 6)},
    design.body.meshes: {
        "RAYS": 5000, "EDGE_MM": 0.2, "SLIVER_MM": 0.01, "LEDGE_MM2": 0.5, "CRUMB_MM3": 1.0,
        "_FACING": -np.cos(np.deg2rad(15.0)),
    },
    design.body.sampled: {
        "_GRID_POINTS": 45_000, "_MARGIN_STEPS": 3, "_COARSE": 3, "_EXACT_STEPS": 3,
        "_FINE_STEP_MM": 1.0, "_MOST_STEPS": 64, "_RELIEF_STEP_MM": 1.0, "_SLIVERS_MM": 0.01,
        "_REACH_SHARE": 0.97,
    },
    design.body.section_lengths: {"_PANELS": 256, "_GAUSS_POINTS": 4},
    design.body.surface_chart: {"STEEPEST": np.sqrt(3.0), "LARGEST_SQUARE": 0.97},
    design.build.bom: {"SCREWS": 4},
    design.build.order_list: {"_WIRE_M_A_PACK": 10.0},
    design.build.print_settings: {
        "STEEP": np.sqrt(0.5), "_LEAST_OVERHANG_MM2": 30.0, "_BED_MM2": 60.0, "_SLENDER": 3.0,
        "_BRIM_MM": 4.0,
    },
    design.catalogue.bus_parts: {"SELECT_BYTES": 2, "PIN_PF": 10.0, "WIRE_PF_PER_MM": 0.06},
    design.catalogue.magnets: {
        "REFERENCE_TEMPERATURE_C": 20.0, "NDFEB_REMANENCE_PER_KELVIN": -0.0011,
        "NDFEB_RECOIL_PERMEABILITY": 1.05,
    },
    design.catalogue.orders: {"SILICONE_KIT_G": 900.0},
    design.catalogue.silicones: {"_INCOMPRESSIBLE": 0.4999},
    design.catalogue.tensile: {
        "_STABLE_FROM_STRETCH": 0.5, "_LARGEST_RESIDUAL_PERCENT": 10.0, "_NORMAL_90": 1.645,
        "_RANGES_TO_STRETCH": (1.25, 1.5, 2.0, 3.0), "_LARGEST_CORRELATION": 0.95,
    },
    design.catalogue.tensile_files: {"FIT_TO_STRETCH": 2.0, "LEAST_POINTS": 6, "_LEAST_STRETCH": 1.1},
    design.fabrication.assembly: {"TOUCHING_MM3": 1e-3, "MATING_MM3": 1.0},
    design.fabrication.casting: {
        "CEILING_MM2": 100.0, "YIELD_SHARE": 0.02, "NEAR_MM": 0.15,
        "OPEN_MM3": 1e-3,
    },
    design.fabrication.check: {"SLIVER_MM3": 1.0},
    design.fabrication.printing: {"_TIGHT": 1.25, "SHARPEST_DEG": 40.0},
    design.fit.boards: {"_TOUCHING_MM": 0.01, "_FLUSH_MM": 0.05},
    design.fit.curved: {"_LARGEST_SHARE": 0.6},
    design.fit.magnet_places: {"MEETING_MM3": 1e-3},
    design.fit.nearest: {"_REACH_MM": 8.0, "_LEAST_BAY_MM": 1.5, "_SMALLER": (0.7, 0.5, 0.35, 0.25)},
    design.layout.blocks: {"_SUNK_MM": 0.5, "_SINKING_STEPS": 4},
    design.layout.boards: {"PACKING": 0.7, "_TOP_FACE": 1},
    design.layout.core_hold: {
        "FLAT_SHARE": 0.7, "NOSE_MM": 4.0, "LOCATOR_NOSE_MM": 6.0, "LOCATOR_GAP_MM": 0.8,
        "_LEVEL": 0.02, "LEAST_FLOOR": 0.3,
    },
    design.layout.core_sockets: {
        "CLEAR_MM": 0.8, "_ROOMY_MM": 2.5, "_PRINTED": 1.25, "_STEEPEST_DEG": 20.0,
        "_CROSSING_DEG": 38.0, "_ASIDE_COS": 0.6, "_FINEST": 9, "_STEPS": 13, "_SEAM_MM": 8.0,
        "_OUT_MM": 5.0,
    },
    design.layout.mould.closure: {
        "SEAT_MM": 2.0, "FLANGE_HEIGHT_MM": 10.0, "FLANGE_OVERLAP_MM": 2.0, "CLIP_MM": 2.5,
    },
    design.layout.mould.frame: {
        "_DOWN": 6, "_STEP_DEG": 15.0, "_WEDGE": np.cos(np.deg2rad(15.0)),
        "_SLOPE": np.sin(np.deg2rad(2.0)), "FLANGE_THICKNESS_MM": 4.0,
    },
    design.layout.mould.pouring: {
        "_STEP_MM": 0.25,
        "_MOST_CORNERS": 200, "LEAST_POUR_MM": 3.0, "_RIM_POINTS": 24, "_WITHIN": 0.999,
        "_POUR_SHIFTS": (0.0, *(sign * k / 4 for k in range(1, 7) for sign in (1, -1))),
    },
    design.layout.mould.pins: {
        "PIN_HEAD_MM": 2.0, "PIN_HEAD_RIM_MM": 1.5, "HEAD_STEP_MM": 1.0, "_OUTSIDE": 0.01,
    },
    design.layout.places.contact_places: {
        "LEAST_COUNT": 2, "MOST_COUNT": 100, "_ROUND_MARGIN_MM": 0.1, "_FINER": 0.8,
        "_FINER_STEPS": 16,
    },
    design.layout.places.coverage: {"_IN_CELL": 5},
    design.layout.places.measures: {"SENSOR_SHARE": 0.6, "LONGEST_PATH_MM": 15.0},
    design.layout.surface: {"_SUPPORT_RING_MM": 2.0},
    design.layout.template_marks: {
        "MARK_LENGTH_MM": 3.0, "MARK_WIDTH_MM": 0.9, "MARK_GAP_MM": 1.3, "CORNER_MM": 4.0,
        "_ANGLES": 32, "_CLOSER_MM": (0.0, 0.25), "_ROUNDS": 6,
    },
    design.layout.tips: {"_ARC_STEPS": 180, "_FILLET_STEPS": 10, "_BODY_MM": 20.0},
    design.mould.flange: {
        "FLANGE_LENGTH_MM": 26.0, "PLACES": (0.15, 0.42, 0.7, 0.9),
        "LONGER_MM": (0.0, 6.0, 12.0, 18.0, 24.0), "LEAST_GAP_MM": 5.0, "BELOW_RIM_MM": 4.0,
        "EDGE_MM": 3.0, "LEAST_STRETCH_MM": 4.0, "_STEP_MM": 0.5,
    },
    design.mould.halves: {"DOWEL_DIAMETER_MM": 4.0, "DOWEL_HEIGHT_MM": 2.5, "BOLT_HOLE_MM": 3.4},
    design.mould.openings: {
        "_SKIN_MM": 0.05, "_LEAST_TRAP_MM": 0.1, "_SHIFTS_MM": (0.5, 1.0, 1.5, 2.0), "_WAYS": 12,
        "_LOWER_MM": 0.05, "_ROUND": 24,
    },
    design.mould.plug_flange: {
        "POST_HEIGHT_MM": 4.0, "POST_MM": 7.3, "BLOCK_MM": 10.0, "CHAMFER_MM": 3.0,
    },
    design.netcdf: {
        "_LARGEST_CHUNK_BYTES": 2**30, "FIRST_READING_S": 120.0,
        "_FIRST_READING_BYTES_PER_S": 2e7, "MEMORY_GIB": 8.0,
    },
    design.placement.asked: {
        "_GROWTH": 1.25, "_LARGEST_GROWTH": 8.0, "_LARGEST_BESIDE": 3.1, "_HALVINGS": 3, "_PLATE": 0.5,
        "_DIGITS": 4, "_MOULD_MM": 30.0,
    },
    design.placement.hooking: {
        "_AZIMUTHS_DEG": tuple(range(0, 180, 5)), "_MOST_REFINED": 3,
        "_FINER_DEG": (-2.0, -1.0, 1.0, 2.0), "_WAYS": 60, "_NEARER_DEG": (8.0, 4.0),
        "_LOOKED_AT_MM": 60.0, "_SPARE": 1.1, "_THICKEST_MM": 16.0, "_SILICONE_BELOW_MM": 5.0,
    },
    design.placement.objects: {
        "SHARES": (0.66, 0.62, 0.58, 0.54, 0.5, 0.46, 0.42, 0.38, 0.34, 0.3, 0.26, 0.22),
        "COARSE": (0.66, 0.54, 0.42, 0.3), "_COUNTS": (5, 4, 3, 2, 1), "_SIDE_HOLE_MM": 3.0,
        "_LEAST_BORE_MM": 4.0, "_FLOOR_MM": 1.0, "_FEWEST": (1, 2), "_HALF_RECESS_MM": 3.25,
        "_TIP_RADII_MM": (5.0, 4.0, 3.0, 2.0),
        "TRIMS": (
            Trim(8.0, 6.0, 3.0), Trim(7.0, 5.0, 3.0), Trim(6.0, 4.0, 3.0), Trim(5.0, 4.0, 2.5),
        ),
        "_PITCHES_MM": (3.0, 2.5, 2.0, 1.5, 1.0), "_LEAST_PLACES": 16,
        "_DEPTHS_MM": (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0),
    },
    design.placement.paths: {"_LONG": 0.9},
    design.placement.patterns: {"_CORNERS_DEG": 45.0},
    design.placement.room: {
        "_ROOMY": 1.25, "_LAYER_MM": 0.25, "_WALL_DEG": 45.0, "_STEP_MM": 0.05, "_EDGE_POINTS": 5,
        "_FACING_DEG": 18.0, "_ROUND": 24, "_ALONG_MM": 0.25, "_EXACT_MM": 1e-6,
    },
    design.search.faces: {"_ALIKE": 0.1},
    design.solids.booleans: {"_FINENESS": (5e-3, 0.1)},
    design.solids.curved_template: {"RIM_MM": 6.0, "NOTCH_MM": 2.0, "_OVER_MM": 1.0, "_ALIKE_MM": 0.05},
    design.solids.foreign: {"_TOLERANCE_MM": 0.03, "_ANGLE_RAD": 0.2, "_LARGEST_MM": 2000.0},
    design.solids.jig: {
        "PLATE_MM": 6.0, "MARGIN_MM": 16.0, "BOLT_HOLE_MM": 5.5, "BOLT_INSET_MM": 7.0,
        "POST_IN_CORE_MM": 10.0, "POST_WALL_MM": 3.0, "WIRE_CHANNEL_MM": (8.0, 3.0),
        "MARK_MM": (1.0, 0.8), "RECESS_MM": 3.0, "CLEAR_MM": 1.0, "CUP_SHARE": 0.2,
        "SLOT_SHARES": (0.9, 0.1),
    },
    design.solids.magnet_template: {
        "PLATE_MM": 3.0, "LIP_MM": (2.0, 3.0), "MARK_DEPTH_MM": 0.8,
    },
    design.solids.primitives: {"OVERSHOOT_MM": 0.5},
    design.solids.probes: {
        "SHAFT_LENGTH_MM": 10.0, "PLATE_MM": 4.0, "PLATE_MARGIN_MM": 5.0, "_ABOVE_FILLET_MM": 4.0,
        "_SHAFT_SHARE": 0.6,
    },
    design.solids.sampled: {
        "_OVERSHOOT_MM": 0.5, "_SECTIONS": 64, "_LEAST_HOLLOW_MM": 3.0, "_LEANING": 0.5,
    },
    design.spec.body: {"LONGEST_EDGE_MM": (5.0, 1000.0)},
    design.spec.learning: {
        "LIMITS_OF_USE": {
            "grasp": {"position_bound_mm": 1.5, "detectable_force_n": 5.0},
            "touch": {"position_bound_mm": 1.0, "detectable_force_n": 1.0},
            "presence": {"position_bound_mm": 5.0, "detectable_force_n": 5.0},
        },
    },
    design.spec.load_cell: {"PINS_OF_KIND": {"none": 0, "hx711": 2, "analog": 1}},
    design.spec.object: {
        "LARGEST_RATIO_WITHOUT_PRESSURE": 0.4999, "LEAST_RATIO_WITH_PRESSURE": 0.01,
        "LARGEST_RATIO_OF_P2": 0.45,
    },
    design.spec_io: {"_LARGEST_BYTES": 250_000},
    design.wiring.bus_limits: {
        "_SINK_MA": 3.0, "_LOW_V": 0.4, "_RISE": 0.8473, "_LARGEST_PF": 400.0,
        "STANDARD_KHZ": 100.0, "FAST_KHZ": 400.0,
        "_E12": (1.0, 1.2, 1.5, 1.8, 2.2, 2.7, 3.3, 3.9, 4.7, 5.6, 6.8, 8.2),
    },
    design.wiring.bus_plan: {"_CHIP_V": 3.3, "_BUFFERS_A_PACKAGE": 6},
    design.wiring.dealing: {"_FIRST_ADDRESS": 16},
    design.wiring.lengths: {"LEAD_MM": 200.0},
    design.wiring.load_cell: {
        "LINE_CHARACTERS": 28, "ANALOG_LINES_HZ": 40.0, "HX711_STEPS_PER_V_PER_V": 2**31,
        "DIVIDER_KOHM": (10.0, 15.0), "_HX711_SUPPLY_MA": 6.5,
    },
    design.wiring.wires: {"_STRIP_MM": 60.0, "LOAD_CABLE_MM": 200.0},
}  # fmt: skip


@pytest.mark.parametrize("module", FIGURES, ids=lambda module: module.__name__)
def test_figures_are_those_that_were_chosen(module):
    for name, value in FIGURES[module].items():
        found = getattr(module, name)
        assert found == (pytest.approx(value) if isinstance(value, float) else value), name
