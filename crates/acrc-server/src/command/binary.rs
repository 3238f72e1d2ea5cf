//! Packets of the binary host interface, executed by the controller between two ticks.
//!
//! A request that is refused is not answered, as the packets have no form for that; the refusal goes to the log. Requests for
//! parameters that do not exist are answered with zeros, so that their client is not left waiting; a peek outside of memory is not.

use acrc_catalog::OperandClass;
use acrc_controller::{
    Controller, Conversion, Coordinate, HostArc, HostError, HostMove, HostPath, MoveExtras, MoveMode, MoveStart,
    Override, Queued,
};
use acrc_wire::binary::{
    self, Address, ArcDirection, DataReply, DataRequest, FlagChange, Number, OverrideKind, Path, PeekReply,
    RapidMoveModes, StartRule, VariableKind,
};
use acrc_wire::{Channel, Field, Reply, Request, WireOptions};
use bytes::BytesMut;

use crate::core::Core;

/// Fields of a data packet, at most.
const FIELDS: usize = 8;
/// Fields of a peek, at most.
const PEEKED: usize = 255;

/// Executes a request other than a move, and puts the answer behind what is to be sent if it has one.
pub(super) fn execute(
    core: &mut Core,
    request: &Request<'_>,
    wire: &WireOptions,
    out: &mut BytesMut,
) -> Result<(), HostError> {
    if request.is_answered() { read(&core.controller, request, out) } else { write(core, request, wire) }
}

fn read(controller: &Controller, request: &Request<'_>, out: &mut BytesMut) -> Result<(), HostError> {
    let mut answer = |reply: Reply<'_>| Channel::ethernet().reply(&reply, out);
    match *request {
        Request::GetLong { parameter } => {
            let value = controller.parameter_long(u32::from(parameter)).unwrap_or_default();
            answer(Reply::Long { parameter, value });
        }
        Request::GetSingle { parameter } => {
            let value = controller.parameter_single(u32::from(parameter)).unwrap_or_default();
            answer(Reply::Single { parameter, value });
        }
        Request::Data(request) => {
            let mut fields = [Field::default(); FIELDS];
            if let Some(reply) = data_reply(controller, request, &mut fields) {
                answer(Reply::Data(reply));
            }
        }
        Request::Peek(request) => {
            let mut values = [0; PEEKED];
            let count = usize::from(request.count);
            let values = values.get_mut(..count).unwrap_or_default();
            controller.peek(conversion(request.conversion), request.address, values)?;
            let mut fields = [Field::default(); PEEKED];
            for (field, value) in fields.iter_mut().zip(values) {
                *field = Field(*value);
            }
            if let Some(reply) = PeekReply::new(request, fields.get(..count).unwrap_or_default()) {
                answer(Reply::Peek(reply));
            }
        }
        Request::Address(request) => {
            let Address { program, kind } = request;
            answer(Reply::Address { request, address: controller.address_of(program, class(kind)) });
        }
        Request::ParameterAddress { parameter } => {
            answer(Reply::ParameterAddress { parameter, address: controller.parameter_address(u32::from(parameter)) });
        }
        _ => {}
    }
    Ok(())
}

fn write(core: &mut Core, request: &Request<'_>, wire: &WireOptions) -> Result<(), HostError> {
    let Core { controller, observer, .. } = core;
    let observer = &mut **observer;
    match *request {
        Request::SetLong { parameter, value } => controller.set_parameter_long(u32::from(parameter), value, observer),
        Request::SetSingle { parameter, value } => {
            controller.set_parameter_single(u32::from(parameter), value, observer)
        }
        Request::ParameterMask { parameter, mask } => {
            controller.mask_parameter(u32::from(parameter), mask.clear, mask.set, observer)
        }
        Request::Mask { address, mask } => controller.mask(address, mask.clear, mask.set, observer),
        Request::Poke(poke) => {
            let mut fields = [0; PEEKED];
            for (place, field) in fields.iter_mut().zip(poke.fields().iter()) {
                *place = field.0;
            }
            let fields = fields.get(..poke.fields().len()).unwrap_or_default();
            controller.poke(conversion(poke.conversion()), poke.address(), fields, observer)
        }
        Request::Flag(FlagChange { flag, set }) => controller.set_flag(u32::from(flag), set, observer),
        Request::Override(change) => {
            let kind = match change.kind {
                OverrideKind::Feedrate => Override::Feedrate,
                OverrideKind::Rapid => Override::Rapid,
            };
            controller.set_override(kind, change.masters(wire), change.value, observer)
        }
        _ => Ok(()),
    }
}

fn data_reply<'f>(
    controller: &Controller,
    request: DataRequest,
    fields: &'f mut [Field; FIELDS],
) -> Option<DataReply<'f>> {
    for (field, parameter) in fields.iter_mut().zip(request.parameters()) {
        let value = parameter.and_then(|parameter| controller.parameter_field(u32::from(parameter)));
        *field = Field(value.unwrap_or_default());
    }
    DataReply::new(request, fields.get(..request.count())?)
}

/// Queues a move.
pub(super) fn queue(core: &mut Core, ordered: &HostMove) -> Result<Queued, HostError> {
    core.controller.host_move(ordered, &mut *core.observer)
}

/// A move as the controller takes it. `None` for an arc in the plane that the guide reserves.
pub(super) fn ordered(core: &Core, packet: &binary::Move) -> Option<HostMove> {
    let master = packet.master().number();
    let rapid =
        if core.controller.has_rapid_move_modes(master) { RapidMoveModes::Enabled } else { RapidMoveModes::Disabled };
    let mut ordered = HostMove {
        master,
        velocity: packet.velocity(),
        final_velocity: packet.final_velocity(),
        acceleration: packet.acceleration(),
        start: start(packet.rule(rapid)),
        extras: MoveExtras {
            counts: packet.counter().is_some(),
            interrupts: packet.interrupts(),
            checks_block_skip: packet.checks_block_skip(),
        },
        incremental: packet.is_incremental(),
        targets: Default::default(),
        path: path(packet.path())?,
    };
    for (slave, number) in packet.targets() {
        if let Some(target) = ordered.targets.get_mut(usize::from(slave.number())) {
            *target = Some(coordinate(number));
        }
    }
    Some(ordered)
}

fn start(rule: StartRule) -> MoveStart {
    match rule {
        StartRule::Lockouts { final_velocity, feedrate_override, stop_ramp } => {
            MoveStart::Lockouts { final_velocity, feedrate_override, stop_ramp }
        }
        StartRule::Mode { mode, override_lockout } => {
            let mode = match mode {
                binary::MoveMode::FeedContinuous => MoveMode::FeedContinuous,
                binary::MoveMode::FeedCornering => MoveMode::FeedCornering,
                binary::MoveMode::FeedStopping => MoveMode::FeedStopping,
                binary::MoveMode::Rapid => MoveMode::Rapid,
            };
            MoveStart::Mode { mode, override_lockout }
        }
    }
}

fn path(path: Path) -> Option<HostPath> {
    Some(match path {
        Path::Line => HostPath::Line,
        Path::Spline { knot } => HostPath::Spline { knot },
        Path::Nurb { knot, weight } => HostPath::Nurb { knot, weight },
        Path::Arc(arc) => HostPath::Arc(HostArc {
            slaves: arc.plane?.axes().map(binary::Slot::number),
            counterclockwise: arc.direction == ArcDirection::Counterclockwise,
            center: arc.center.map(coordinate),
            incremental: arc.incremental,
            scaling: arc.scaling,
        }),
    })
}

fn coordinate(number: Number) -> Coordinate {
    match number {
        Number::Long(pulses) => Coordinate::Pulses(pulses),
        Number::Single(units) => Coordinate::Units(units),
    }
}

fn conversion(conversion: binary::Conversion) -> Conversion {
    match conversion {
        binary::Conversion::Long => Conversion::Long,
        binary::Conversion::Double => Conversion::Double,
        binary::Conversion::Single => Conversion::Single,
    }
}

fn class(kind: VariableKind) -> OperandClass {
    match kind {
        VariableKind::DoubleVariables => OperandClass::Dv,
        VariableKind::DoubleArrays => OperandClass::Da,
        VariableKind::SingleVariables => OperandClass::Sv,
        VariableKind::SingleArrays => OperandClass::Sa,
        VariableKind::LongVariables => OperandClass::Lv,
        VariableKind::LongArrays => OperandClass::La,
        VariableKind::StringVariables => OperandClass::StringV,
        VariableKind::StringArrays => OperandClass::StringA,
    }
}
