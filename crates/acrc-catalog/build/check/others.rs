//! Checks of models, messages and memory.

use super::Faults;
use crate::catalogue::rows::Catalogue;

pub fn check(catalogue: &Catalogue, faults: &mut Faults) {
    let models = &catalogue.models;
    faults.unique("name", models.iter().map(|row| (row.name.to_uppercase(), format!("model {}", row.name))));
    for row in models {
        let label = format!("model {}", row.name);
        if row.user_memory == 0 || row.programs == 0 || row.axes == 0 {
            faults.add(&label, "memory, programs and axes must not be zero");
        }
        if !(row.servo_period > 0.0 && row.servo_period < 1.0) {
            faults.add(&label, format_args!("a servo period of {} s is not possible", row.servo_period));
        }
        faults.origin(&label, &row.source, &row.confidence);
    }
    if models.iter().filter(|row| row.default).count() != 1 {
        faults.add("models", "exactly one must be the default");
    }
    let messages = &catalogue.messages;
    faults.unique("id", messages.iter().map(|row| (row.id, format!("message {}", row.name))));
    faults.unique("name", messages.iter().map(|row| (row.name.clone(), format!("message {}", row.name))));
    for row in messages {
        let label = format!("message {}", row.name);
        if row.text.is_empty() || row.meaning.is_empty() {
            faults.add(&label, "text and meaning must not be empty");
        }
        faults.origin(&label, &row.source, &row.confidence);
    }
    memory(catalogue, faults);
}

fn memory(catalogue: &Catalogue, faults: &mut Faults) {
    let (factory, costs) = (&catalogue.memory.factory, &catalogue.memory.cost);
    if factory.programs == 0 || factory.program_bytes % u32::from(factory.programs) != 0 {
        faults.add("memory", "the factory memory must be shared equally by the programs");
    }
    faults.origin("memory", &factory.source, &factory.confidence);
    faults.unique("constant", costs.iter().map(|row| (row.constant.clone(), format!("memory {}", row.name))));
    for row in costs {
        let label = format!("memory {}", row.name);
        if row.each == 0 && row.character == 0 {
            faults.add(&label, "a unit must cost something");
        }
        if !["sys", "prog", "text"].contains(&row.level.as_str()) {
            faults.add(&label, format_args!("there is no level {}", row.level));
        }
        faults.origin(&label, &row.source, &row.confidence);
    }
}
