//! Gear, hand wheel, and gantry lock of an axis (guide, "Gear Profiler", "Setpoint Control Commands").

use acrc_motion::axis::GantryLock;

use crate::axis::Lock;
use crate::error::ControllerError;
use crate::machine::Machine;

impl Machine {
    /// Connects an axis to the source of its gear, or disconnects it.
    pub(crate) fn switch_gear(&mut self, axis: u8, on: bool) -> Result<(), ControllerError> {
        self.admit(axis, on)?;
        let follower = self.follow(self.axes[usize::from(axis)].followers.gear.feed);
        let state = &mut self.axes[usize::from(axis)];
        if on {
            state.engages = true;
            state.followers.gear = follower;
        } else {
            state.engages = false;
            state.profilers.gear.off();
        }
        self.motion.wake();
        Ok(())
    }

    /// The same for a hand wheel.
    pub(crate) fn switch_hand_wheel(&mut self, axis: u8, on: bool) -> Result<(), ControllerError> {
        self.admit(axis, on)?;
        let follower = self.follow(self.axes[usize::from(axis)].followers.hand_wheel.feed);
        let state = &mut self.axes[usize::from(axis)];
        if on {
            state.profilers.hand_wheel.on();
            state.followers.hand_wheel = follower;
        } else {
            state.profilers.hand_wheel.off();
        }
        self.motion.wake();
        Ok(())
    }

    /// Takes the settings of now; a killed axis is not switched on.
    pub(super) fn admit(&mut self, axis: u8, on: bool) -> Result<(), ControllerError> {
        if on {
            self.may_move(axis)?;
        }
        self.refresh_axes();
        Ok(())
    }

    /// Lets an axis follow the primary setpoint of another one from now on (`LOCK`).
    pub(crate) fn lock(&mut self, follower: u8, leader: u8) -> Result<(), ControllerError> {
        if self.axis_in_motion(follower) {
            return Err(ControllerError::InMotion);
        }
        let mut next = Some(leader);
        while let Some(axis) = next {
            if axis == follower {
                let problem = format!("AXIS{follower} would follow itself");
                return Err(ControllerError::BadValue { command: "LOCK", problem });
            }
            next = self.axes[usize::from(axis)].lock.map(|lock| lock.leader);
        }
        let gantry = GantryLock::new(self.primary_setpoint(leader), self.primary_setpoint(follower));
        self.axes[usize::from(follower)].lock = Some(Lock { leader, gantry });
        self.motion.wake();
        Ok(())
    }

    fn primary_setpoint(&self, axis: u8) -> f64 {
        self.registers_of(axis).primary_setpoint()
    }

    /// The axes that are locked to one, and their primary setpoints, units.
    pub(super) fn followers_of(&self, leader: u8) -> Vec<(u8, f64)> {
        let follows = |axis: &u8| self.axes[usize::from(*axis)].lock.is_some_and(|lock| lock.leader == leader);
        (0..self.model.axes).filter(follows).map(|axis| (axis, self.primary_setpoint(axis))).collect()
    }

    /// Lets a locked axis keep the distance from now on in which its primary setpoint is this, units.
    pub(super) fn lock_at(&mut self, follower: u8, setpoint: f64) {
        let Some(Lock { leader, .. }) = self.axes[usize::from(follower)].lock else { return };
        let gantry = GantryLock::new(self.primary_setpoint(leader), setpoint);
        self.axes[usize::from(follower)].lock = Some(Lock { leader, gantry });
    }

    /// Lets an axis go again, where it stands (`UNLOCK`).
    pub(crate) fn unlock(&mut self, follower: u8) -> Result<(), ControllerError> {
        if self.axes[usize::from(follower)].lock.is_none() {
            return Ok(());
        }
        if self.axis_in_motion(follower) {
            return Err(ControllerError::InMotion);
        }
        let led = self.registers_of(follower);
        self.axes[usize::from(follower)].lock = None;
        self.set_coordinated(follower, led.coordinated)?;
        self.motion.wake();
        Ok(())
    }
}
