#pragma once

namespace telar {

/// Number of the fault that the planted text has; 0: none. The shading text takes no argument that could carry it: it
/// stands alone in the one program that has planted text.
extern int plantedFault;

inline bool planted(int fault) { return fault == plantedFault; }

}  // namespace telar
