#include <array>

#include "display/tube/preset.h"

namespace kinescope {
namespace {

// One row a key: name, unit, least, most, where it lies, what it means.
#define AT(field) [](TubeSettings& s) -> double& { return s.field; }
constexpr std::array kNumbers{
    TubeNumber{"glass.diagonal", "mm", 10, 5000, AT(glass.diagonal_mm), "of the visible picture"},
    TubeNumber{"glass.aspect", "", 0.25, 4, AT(glass.aspect), "width over height"},
    TubeNumber{"glass.curvature", "mm", 0, 1e5, AT(glass.curvature_mm), "radius; 0 is flat"},
    TubeNumber{"glass.distance", "mm", 50, 1e5, AT(glass.distance_mm), "from the camera"},
    TubeNumber{"glass.halation", "", 0, 0.5, AT(glass.halation), "share of light that goes astray"},
    TubeNumber{"glass.halation_width", "mm", 0.1, 100, AT(glass.halation_mm), "its deviation"},
    TubeNumber{"glass.ambient", "", 0, 1, AT(glass.ambient), "the room's light, of white"},
    TubeNumber{"gun.gamma", "", 0.5, 5, AT(gun.gamma), "current = drive ^ gamma"},
    TubeNumber{"gun.contrast", "", 0, 4, AT(gun.contrast), "gain of the video amplifier"},
    TubeNumber{"gun.brightness", "", -1, 1, AT(gun.brightness), "added to the drive"},
    TubeNumber{"gun.blanking", "", 0, 2, AT(gun.blanking), "how far below black retrace is driven"},
    TubeNumber{"gun.sync", "", 0, 1, AT(gun.sync), "how far below black sync tips are"},
    TubeNumber{"gun.bandwidth", "Hz", 0, 1e10, AT(gun.bandwidth_hz), "video; 0 is unlimited"},
    TubeNumber{"spot.sigma", "mm", 0, 20, AT(spot.sigma_mm), "deviation at white"},
    TubeNumber{"spot.least", "", 0.6, 1, AT(spot.least), "share of it left at no current"},
    TubeNumber{"spot.focus", "", 0.1, 20, AT(spot.focus), "multiplies it"},
    TubeNumber{"spot.astigmatism", "", 0.2, 5, AT(spot.astigmatism), "width over height"},
    TubeNumber{"spot.sag_power", "", 0, 2, AT(spot.sag_power),
               "the spot grows as the high voltage to the minus this"},
    TubeNumber{"deflection.width", "", 0.1, 3, AT(deflection.width), "of the glass"},
    TubeNumber{"deflection.height", "", 0.1, 3, AT(deflection.height), "of the glass"},
    TubeNumber{"deflection.shift_x", "", -1, 1, AT(deflection.shift_x), "to the right"},
    TubeNumber{"deflection.shift_y", "", -1, 1, AT(deflection.shift_y), "down"},
    TubeNumber{"deflection.pincushion_x", "", -0.3, 0.3, AT(deflection.pincushion_x),
               "how far corners stick out sideways"},
    TubeNumber{"deflection.pincushion_y", "", -0.3, 0.3, AT(deflection.pincushion_y),
               "how far corners stick out up and down"},
    TubeNumber{"deflection.keystone", "", -0.5, 0.5, AT(deflection.keystone), "wider below"},
    TubeNumber{"deflection.rotation", "deg", -45, 45, AT(deflection.rotation_deg), "clockwise"},
    TubeNumber{"deflection.s_curve", "", -0.5, 0.5, AT(deflection.s_curve), "slower at the ends"},
    TubeNumber{"sweep.line_rate", "Hz", 0, 1e6, AT(sweep.line_hz), "if unlocked; 0 is locked"},
    TubeNumber{"sweep.field_rate", "Hz", 0, 1000, AT(sweep.field_hz), "if unlocked; 0 is locked"},
    TubeNumber{"sweep.interlace_error", "", -1, 1, AT(sweep.interlace_error),
               "of half a line: how late second fields are"},
    TubeNumber{"sweep.hum_x", "", 0, 0.5, AT(sweep.hum_x), "swing with the mains, sideways"},
    TubeNumber{"sweep.hum_y", "", 0, 0.5, AT(sweep.hum_y), "swing with the mains, up and down"},
    TubeNumber{"sweep.hum_rate", "Hz", 0, 1000, AT(sweep.hum_hz), "of the mains"},
    TubeNumber{"sweep.sag", "", 0, 0.5, AT(sweep.sag), "of the high voltage, at steady white"},
    TubeNumber{"sweep.sag_time", "s", 0, 10, AT(sweep.sag_time_s), "in which it follows"},
    TubeNumber{"mask.pitch", "mm", 0.05, 20, AT(mask.pitch_mm), "of a triad"},
    TubeNumber{"mask.open", "", 0.05, 1, AT(mask.open), "share of an opening's place"},
    TubeNumber{"mask.slot", "mm", 0.05, 50, AT(mask.slot_mm), "from one slot down to the next"},
    TubeNumber{"mask.bridge", "", 0, 0.9, AT(mask.bridge), "share of it that is metal"},
    TubeNumber{"mask.wires", "", 0, 8, AT(mask.wires), "a grille's damper wires"},
    TubeNumber{"mask.wire", "mm", 0, 2, AT(mask.wire_mm), "their thickness"},
    TubeNumber{"convergence.red.x", "mm", -20, 20, AT(deflection.convergence[0].x_mm),
               "to the right"},
    TubeNumber{"convergence.red.y", "mm", -20, 20, AT(deflection.convergence[0].y_mm), "down"},
    TubeNumber{"convergence.red.edge_x", "mm", -20, 20, AT(deflection.convergence[0].edge_x_mm),
               "to the right at the edges"},
    TubeNumber{"convergence.red.edge_y", "mm", -20, 20, AT(deflection.convergence[0].edge_y_mm),
               "down at the edges"},
    TubeNumber{"convergence.green.x", "mm", -20, 20, AT(deflection.convergence[1].x_mm),
               "to the right"},
    TubeNumber{"convergence.green.y", "mm", -20, 20, AT(deflection.convergence[1].y_mm), "down"},
    TubeNumber{"convergence.green.edge_x", "mm", -20, 20, AT(deflection.convergence[1].edge_x_mm),
               "to the right at the edges"},
    TubeNumber{"convergence.green.edge_y", "mm", -20, 20, AT(deflection.convergence[1].edge_y_mm),
               "down at the edges"},
    TubeNumber{"convergence.blue.x", "mm", -20, 20, AT(deflection.convergence[2].x_mm),
               "to the right"},
    TubeNumber{"convergence.blue.y", "mm", -20, 20, AT(deflection.convergence[2].y_mm), "down"},
    TubeNumber{"convergence.blue.edge_x", "mm", -20, 20, AT(deflection.convergence[2].edge_x_mm),
               "to the right at the edges"},
    TubeNumber{"convergence.blue.edge_y", "mm", -20, 20, AT(deflection.convergence[2].edge_y_mm),
               "down at the edges"},
#undef AT
};

}  // namespace

std::span<const TubeNumber> tube_numbers() { return kNumbers; }

}  // namespace kinescope
