// The display file of the light pen's demo.
#pragma once

namespace kinescope {

// Four parts placed by a move and a call each; the cross's arms are drawn from outside in, so that
// the first stroke seen of each tells how far the pen reaches.
inline constexpr const char* kPenParts = R"(
start:  sync
cross:  move 2048 2048
        pen 1
aim:    call arms
        pen 1
parts:  move 900 2900
        call gate
        move 900 1300
        call gate
        move 2600 2100
        call gate
        move 2300 900
        call lamp
        pen 0
        again
gate:   rdraw 500 0
        rdraw 150 -120
        rdraw 60 -180
        rdraw -60 -180
        rdraw -150 -120
        rdraw -500 0
        rdraw 0 600
        return
lamp:   rdraw 300 0
        rdraw 150 260
        rdraw -150 260
        rdraw -300 0
        rdraw -150 -260
        rdraw 150 -260
        rmove 0 520
        rdraw 300 -520
        return
right:
arms:   rmove 96 0
        rdraw -48 0
        rdraw -48 0
left:   rmove -96 0
        rdraw 48 0
        rdraw 48 0
up:     rmove 0 96
        rdraw 0 -48
        rdraw 0 -48
down:   rmove 0 -96
        rdraw 0 48
        rdraw 0 48
        return
)";

}  // namespace kinescope
