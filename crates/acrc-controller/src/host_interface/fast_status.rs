//! Fast status: eight parameters of each of ten groups at once (Ethernet specification, "Fast Status"; command list, `FSTAT`).
//!
//! `FSTATn (group, index)` chooses a group by group code and group index of the binary interface. What is not chosen, or does not
//! exist, is 0. `FSTAT OFF` keeps what was there last until `FSTAT ON`; `FSTAT PERIOD` is the least time in milliseconds from one
//! update to the next.

use acrc_catalog::{CommandId, GROUP_FIELDS, ParameterBlock, command};

use crate::controller::Controller;
use crate::machine::Machine;
use crate::settings::Item;

/// Groups of fast status.
pub const FAST_STATUS_GROUPS: usize = 10;

/// The fields of fast status: the bits of a long integer or of an IEEE single each, as the parameters are.
pub type FastStatus = [[u32; GROUP_FIELDS as usize]; FAST_STATUS_GROUPS];

/// When fast status was brought up to date.
#[derive(Clone, Debug, Default)]
pub(crate) struct FastUpdates {
    /// `FSTAT OFF`
    pub(crate) stopped: bool,
    /// The last update, and its tick.
    last: Option<(u64, FastStatus)>,
}

impl Controller {
    /// What a client of fast status gets now.
    pub fn fast_status(&mut self) -> FastStatus {
        self.machine.update_fast_status()
    }

    /// The parameters that fast status shows, by group and field; `None` where no group was chosen, and behind the last object.
    pub fn fast_status_parameters(&self) -> [[Option<u32>; GROUP_FIELDS as usize]; FAST_STATUS_GROUPS] {
        std::array::from_fn(|group| {
            let chosen = self.machine.fast_status_group(group);
            std::array::from_fn(|bit| chosen.and_then(|(block, code, index)| block.group_field(code, index, bit as u8)))
        })
    }
}

impl Machine {
    fn update_fast_status(&mut self) -> FastStatus {
        let now = self.clock.ticks();
        if let Some((tick, last)) = self.fast_status.last {
            let milliseconds = (now - tick) as f64 * self.clock.period() * 1000.0;
            let period = self.setting_number(command::FSTAT_PERIOD, 0).unwrap_or(0.0);
            if self.fast_status.stopped || milliseconds < period {
                return last;
            }
        }
        let fields = std::array::from_fn(|group| {
            let chosen = self.fast_status_group(group);
            std::array::from_fn(|bit| {
                let number = chosen.and_then(|(block, code, index)| block.group_field(code, index, bit as u8));
                let value = number.and_then(|number| self.read_parameter(i64::from(number)).ok());
                value.and_then(|value| super::number::bits(&value)).unwrap_or(0)
            })
        });
        self.fast_status.last = Some((now, fields));
        fields
    }

    /// The block, code and index that `FSTATn` has chosen.
    fn fast_status_group(&self, group: usize) -> Option<(&'static ParameterBlock, u8, u8)> {
        let items = self.settings.of(command::FSTAT, group as u16);
        let byte = |item: &Item| match item {
            Item::Number(value) => u8::try_from(value.to_long().ok()?).ok(),
            _ => None,
        };
        let [code, index] = &items[..] else { return None };
        let (code, index) = (byte(code)?, byte(index)?);
        Some((ParameterBlock::of_group(code)?, code, index))
    }

    fn setting_number(&self, command: CommandId, object: u16) -> Option<f64> {
        match self.settings.of(command, object).first() {
            Some(Item::Number(value)) => value.to_f64().ok(),
            _ => None,
        }
    }
}
