// One target, picture and decal, painted: what the tests of the C ABI hand in where a call wants a handle.
#pragma once

#include "test_session.h"

namespace support {

struct OneOfEach {
    TxcTarget target = 0;
    TxcImage image = 0;
    TxcLayer layer = 0;
};

inline OneOfEach make_one_of_each(TestSession& session) {
    OneOfEach made;
    made.target = session.target(16, 16);
    made.image = session.image(Picture(2, 2, {1, 2, 3, 255}));
    made.layer = session.layer(made.target, decal_def(made.image));
    session.update(made.target);
    return made;
}

}  // namespace support
