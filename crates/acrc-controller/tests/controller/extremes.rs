//! Values at the edges of what a number can be are refused or taken, and never end the run by themselves.

use crate::support::Sim;

#[test]
fn no_value_ends_the_run() {
    let values = ["1e308", "-1e308", "1e-308", "0", "-1", "2147483647", "-2147483648", "4294967295", "1e20"];
    let statements = [
        "RES X(@) : X1",
        "PPU X(@) : X1 : INH -516",
        "RES X(@) : PPU X(@) : PRINT P12288, P6144",
        "PPU X(@) : P12288 = (@) : P6144 = (@) : PRINT P12288, P6144",
        "X(@) : DWL 0.01",
        "X/(@) : X/(@) : SET 520 : DWL 0.01 : SET 523",
        "VEL (@) : X10",
        "ACC (@) DEC (@) STP (@) : X10 : DWL 0.01 : SET 520",
        "JRK (@) : X10",
        "TMOV (@) : X10",
        "IVEL (@) FVEL (@) : X10",
        "FOV (@) : X10 : DWL 0.01 : FOV 1",
        "VECDEF X(@) : VECTOR (@) : X1 Y1",
        "ENC0 RES (@) : PRINT P6144",
        "ENC0 RES (@) : X1 : INH -516 : PRINT P6144",
        "DWL (@)",
        "P6916 = (@) : DWL 0.01 : PRINT P6916",
        "P4097 = (@) : P4112 = (@)",
        "SET (@)",
        "INH (@)",
        "PRINT P(@), BIT(@)",
        "P(@) = 1",
        "DIM LV(@)",
    ];
    for value in values {
        for statement in statements {
            Sim::program(&statement.replace('@', value)).until(0.1).run();
        }
        for statement in ["DIM P(@)", "DIM PROG9(@)", "DIM DEF(@)", "PERIOD (@)", "AXIS5 PPU (@)", "AXIS5 RES (@)"] {
            Sim::new(&format!("SYS\n{}\nPRINT P13568\n", statement.replace('@', value))).until(0.1).run();
        }
    }
}
