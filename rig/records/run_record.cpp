#include "rig/records/run_record.h"

namespace foverig {

const char* name_of(Origin origin) {
    switch (origin) {
        case Origin::simulated:
            return "simulated";
        case Origin::recorded:
            return "recorded";
        case Origin::hardware:
            break;
    }
    return "hardware";
}

}  // namespace foverig
