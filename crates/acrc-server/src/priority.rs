//! Which thread goes first when there are more than processors.

/// Lets this thread go before others, as far as the system allows it: whoever keeps time for others works for some microseconds in each
/// millisecond, and would else wait for several of them behind a program that computes. Gives whether it does.
pub(crate) fn go_first() -> bool {
    raise().is_ok()
}

#[cfg(unix)]
fn raise() -> Result<(), thread_priority::Error> {
    use thread_priority::unix::{
        RealtimeThreadSchedulePolicy, ThreadSchedulePolicy, set_thread_priority_and_policy, thread_native_id,
    };
    // The lowest of those that go before all usual ones.
    let policy = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
    set_thread_priority_and_policy(thread_native_id(), thread_priority::ThreadPriority::Min, policy)
}

#[cfg(not(unix))]
fn raise() -> Result<(), thread_priority::Error> {
    thread_priority::set_current_thread_priority(thread_priority::ThreadPriority::Max)
}
