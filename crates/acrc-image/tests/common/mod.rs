//! Generators and helpers shared by the tests.

use acrc_catalog::{
    CommandId, FunctionId, Keyword, ObjectKind, OperandClass, Operator, Shape, UnaryOperator, all_commands,
    all_functions, command,
};
use acrc_image::{AxisName, Instruction, Item, Mark, Node, Separator};
use proptest::prelude::*;
use proptest::sample::select;

/// A constant that a program text can give.
pub(crate) fn constant() -> impl Strategy<Value = Node> {
    let single = any::<f32>().prop_filter("finite", |value| value.is_finite());
    let double = any::<f64>().prop_filter("finite", |value| value.is_finite());
    prop_oneof![any::<i32>().prop_map(Node::Long), single.prop_map(Node::Single), double.prop_map(Node::Double)]
}

fn parens() -> impl Strategy<Value = u8> {
    prop_oneof![4 => Just(0_u8), 2 => Just(1), 1 => 2..8_u8]
}

fn scalar_class() -> impl Strategy<Value = OperandClass> {
    select(OperandClass::ALL)
}

fn array_class() -> impl Strategy<Value = OperandClass> {
    select(OperandClass::ALL.iter().copied().filter(|class| class.is_array()).collect::<Vec<_>>())
}

fn function() -> impl Strategy<Value = FunctionId> {
    select(all_functions().map(|function| function.id).collect::<Vec<_>>())
}

/// An expression; aliases are the first four of the table.
pub(crate) fn expression() -> impl Strategy<Value = Node> {
    let text = proptest::collection::vec(any::<u8>(), 0..6);
    let leaf = prop_oneof![
        4 => constant(),
        1 => (text, parens()).prop_map(|(bytes, parens)| Node::String { bytes, parens }),
        1 => (0..4_u16, parens()).prop_map(|(index, parens)| Node::Alias { index, parens }),
    ];
    leaf.prop_recursive(5, 24, 4, |inner| {
        let boxed = inner.clone().prop_map(Box::new);
        prop_oneof![
            (scalar_class(), boxed.clone(), parens()).prop_map(|(class, index, parens)| Node::Scalar {
                class,
                index,
                parens
            }),
            (array_class(), boxed.clone(), boxed.clone(), parens())
                .prop_map(|(class, array, element, parens)| Node::Array { class, array, element, parens }),
            (select(UnaryOperator::ALL), boxed.clone(), parens()).prop_map(|(op, operand, parens)| Node::Unary {
                op,
                operand,
                parens
            }),
            (select(Operator::ALL), boxed.clone(), boxed, parens())
                .prop_map(|(op, left, right, parens)| Node::Binary { op, left, right, parens }),
            (function(), proptest::collection::vec(inner, 0..=4), parens())
                .prop_map(|(function, arguments, parens)| Node::Call { function, arguments, parens }),
        ]
    })
}

fn axis_name() -> impl Strategy<Value = AxisName> {
    "[A-Z]{1,4}".prop_map(|name| name.parse().expect("one to four letters"))
}

fn object(value: impl Strategy<Value = Option<Box<Node>>>) -> impl Strategy<Value = Node> {
    let index = proptest::option::of(0..1023_u16);
    (select(ObjectKind::ALL), index, any::<bool>(), any::<bool>(), value)
        .prop_map(|(kind, index, slash, prefix, value)| Node::Object { kind, index, slash, prefix, value })
}

fn word() -> impl Strategy<Value = Node> {
    (select(Keyword::ALL), proptest::option::of(0..1023_u16)).prop_map(|(keyword, index)| Node::Word { keyword, index })
}

fn value() -> impl Strategy<Value = Option<Box<Node>>> {
    let tuple = proptest::collection::vec(expression(), 2..=7).prop_map(Node::Tuple);
    proptest::option::of(
        prop_oneof![3 => expression(), 1 => tuple, 1 => object(Just(None)), 1 => word()].prop_map(Box::new),
    )
}

/// Any operand of a statement; labels are the first two of the unit.
pub(crate) fn node() -> impl Strategy<Value = Node> {
    prop_oneof![
        3 => expression(),
        3 => (axis_name(), any::<bool>(), value()).prop_map(|(name, slash, value)| Node::Axis { name, slash, value }),
        1 => object(value()),
        1 => word(),
        1 => proptest::collection::vec(expression(), 2..=7).prop_map(Node::Tuple),
        1 => Just(Node::Interpolation(command::SINE)),
        1 => expression().prop_map(|number| Node::Device(Box::new(number))),
        1 => (0..2_u16).prop_map(Node::LabelRef),
    ]
}

fn item() -> impl Strategy<Value = Item> {
    (node(), select(&Mark::ALL[..])).prop_map(|(node, mark)| Item { node, mark })
}

/// Commands whose operands are checked by what executes them.
fn free_command() -> impl Strategy<Value = CommandId> {
    let free = |shape: Shape| {
        matches!(
            shape,
            Shape::Free | Shape::AxisValues | Shape::Values | Shape::Print | Shape::Move | Shape::None | Shape::Bit
        )
    };
    select(all_commands().filter(|command| free(command.shape)).map(|command| command.id).collect::<Vec<_>>())
}

fn instruction() -> impl Strategy<Value = Instruction> {
    let free = (free_command(), proptest::collection::vec(item(), 0..18));
    let assignment = (expression(), expression())
        .prop_map(|(target, value)| (command::ASSIGNMENT, vec![target.into(), value.into()]));
    let condition =
        (expression(), select(&Mark::ALL[..])).prop_map(|(node, mark)| (command::IF, vec![Item { node, mark }]));
    let remark =
        proptest::collection::vec(any::<u8>(), 0..9).prop_map(|bytes| (command::REM, vec![Node::string(bytes).into()]));
    (select(&Separator::ALL[..]), prop_oneof![4 => free, 1 => assignment, 2 => condition, 1 => remark])
        .prop_map(|(separator, (command, items))| Instruction { address: 0, separator, command, items })
}

/// A unit's worth of statements that the verifier accepts: two labels first, then anything. Addresses are zero.
pub(crate) fn instructions() -> impl Strategy<Value = Vec<Instruction>> {
    let label = |name: &str| Instruction {
        address: 0,
        separator: Separator::Line,
        command: command::LABEL,
        items: vec![Node::string(name).into()],
    };
    proptest::collection::vec(instruction(), 0..8).prop_map(move |statements| {
        let mut all = vec![label("First"), label("Second")];
        for mut statement in statements {
            let then = all.last().is_some_and(|before| {
                before.command == command::IF && before.items.first().is_some_and(|item| item.mark == Mark::Comma)
            });
            if statement.separator == Separator::Then && !then {
                statement.separator = Separator::Colon;
            }
            all.push(statement);
        }
        all
    })
}
