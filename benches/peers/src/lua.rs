//! Lua 5.4, its interpreter as its authors ship it.

use mlua::{Function, Lua};

use crate::programs::Program;
use crate::{Contender, timed};

pub(crate) fn contender(program: &Program) -> Contender {
    let lua = Lua::new();
    let function: Function = lua.load(program.lua()).into_function().expect("the Lua program compiles");
    Box::new(move || {
        // The state must outlive its function.
        let _ = &lua;
        timed(|| function.call(()).expect("the Lua program runs"))
    })
}
