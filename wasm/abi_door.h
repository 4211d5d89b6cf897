// What every function of the C ABI begins with: the session is found and the pointers are checked.
#pragma once

#include "session.h"
#include "texelcast.h"

namespace txc {

IdTable<Session>& abi_sessions();

/// Empties the error detail, finds the session and runs `work` on it.
template <typename Work>
TxcStatus in_session(TxcSession id, Work&& work) {
    error_detail().clear();
    Session* session = abi_sessions().find(id);
    if (session == nullptr) return fail(TXC_STATUS_STALE_HANDLE, "there is no session %u", id);
    return work(*session);
}

/// The same for a call that needs a pointer of the caller's; `name` says which one is null.
template <typename Work>
TxcStatus in_session(TxcSession id, const void* pointer, const char* name, Work&& work) {
    return in_session(id, [&](Session& session) {
        if (pointer == nullptr) return fail(TXC_STATUS_BAD_ARGUMENT, "%s is null", name);
        return work(session);
    });
}

/// A point that is counted from an origin, in model space.
__attribute__((noinline)) inline void copy_point(const glm::vec3& origin, const glm::vec3& point, float (&to)[3]) {
    for (int c = 0; c < 3; ++c) to[c] = origin[c] + point[c];
}

}  // namespace txc
