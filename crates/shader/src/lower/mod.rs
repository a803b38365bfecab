//! naga's IR to instructions.
//!
//! Calls are inlined. A value is a list of registers, one per scalar, so composing, splitting and swizzling cost nothing.
//! Variables are renamed registers until control flow may jump; then they have a home, loads copy and stores select by
//! the mask of the lanes that are here. What follows from constants and uniforms alone goes to a prologue that runs once
//! per draw. Matches over the IR are exhaustive on purpose: what a new version of naga adds must be decided on.

mod access;
mod allocate;
mod arithmetic;
mod emit;
mod expressions;
mod flow;
mod layout;
mod math;
mod matrices;
mod pool;
mod statements;
mod textures;
mod types;
mod variables;

use std::collections::{BTreeSet, HashMap, HashSet};

use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{Expression, Function, Handle, Module, Span};

use crate::Stage;
use crate::machine::{Code, Look};
pub(crate) use allocate::{Draft, Placed};
pub(crate) use flow::uses::inner_blocks;
pub use layout::TextureInfo;
pub(crate) use layout::{Layout, Leaf, Purpose, Slot};
pub(crate) use textures::gather::is_stand_in;

/// A register before allocation.
pub(crate) type Reg = u32;

/// What cannot be lowered, and where.
#[derive(Debug)]
pub(crate) struct Refused {
    pub(crate) message: String,
    pub(crate) span: Span,
    /// Whether it is only too much at a time.
    lacks_registers: bool,
}

impl Refused {
    fn new(message: impl Into<String>, span: Span) -> Self {
        Self { message: message.into(), span, lacks_registers: false }
    }

    fn for_lack_of_registers() -> Self {
        let message = format!("the shader needs more than {} numbers at a time", crate::machine::ROWS);
        Self { lacks_registers: true, ..Self::new(message, Span::UNDEFINED) }
    }
}

/// What a trace hears of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EventKind {
    /// A value got a name or a variable a value.
    Value,
    /// The condition of an `if`, a loop or a `switch`.
    Branch,
    /// Lanes return, break, continue or are discarded.
    Leave,
}

/// An event; `R` numbers registers.
#[derive(Clone, Debug)]
pub(crate) struct Event<R> {
    pub(crate) kind: EventKind,
    pub(crate) span: Span,
    pub(crate) name: String,
    pub(crate) ty: crate::ValueType,
    pub(crate) registers: Vec<R>,
    /// The lanes that are here; all if there is none.
    pub(crate) mask: Option<R>,
}

/// The lowered program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lowered {
    /// For any values of the uniforms.
    pub(crate) placed: Placed,
    pub(crate) layout: Layout,
    /// What a draw's specialisation begins with, and where its registers lie in the file after the prologue of `placed`;
    /// none if the program is traced.
    pub(crate) draft: Option<(Draft, Vec<u16>)>,
}

/// A dynamic index: the value of `index` stands for one of the `choices`, as an offset in registers.
#[derive(Clone, Debug)]
struct Choice {
    index: Reg,
    offsets: Vec<usize>,
}

/// What an expression is.
#[derive(Clone, Debug)]
enum Item {
    Value(Vec<Reg>),
    /// A variable or a part of it.
    Place {
        var: usize,
        offset: usize,
        dynamic: Option<Choice>,
    },
    /// Uniform memory from a word on; dynamic: register, stride in words, last index.
    Uniform {
        word: usize,
        dynamic: Option<(Reg, usize, usize)>,
    },
    Texture(usize),
    Nothing,
}

#[derive(Clone, Debug)]
struct Variable {
    registers: Vec<Reg>,
    /// How many enclosing jumps made it have fixed registers.
    homes: u32,
    name: String,
    /// The mask of the branch that alone uses the variable: stores under it need no mask.
    private: Option<Reg>,
    /// Why it cannot be stored to.
    constant: Option<&'static str>,
}

/// An instruction before allocation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VirtualOp {
    pub(crate) code: Code,
    pub(crate) s: u8,
    pub(crate) n: u16,
    pub(crate) d: Reg,
    pub(crate) a: Reg,
    pub(crate) b: Reg,
    pub(crate) c: Reg,
    pub(crate) imm: u32,
}

/// The function that is being inlined.
struct Frame<'a> {
    function: &'a Function,
    info: &'a FunctionInfo,
    items: HashMap<Handle<Expression>, Item>,
    locals: HashMap<Handle<naga::LocalVariable>, usize>,
    /// Locals that are constants in the memory of the uniforms.
    pooled: HashMap<Handle<naga::LocalVariable>, Item>,
    /// How often each local is named in the whole function.
    uses: HashMap<Handle<naga::LocalVariable>, usize>,
    arguments: Vec<Item>,
    result: Option<usize>,
    returned: usize,
}

/// A loop or switch around what is being lowered.
struct Enclosing {
    broken: usize,
    continued: usize,
    /// Jumps to the end and to the continuing block, where all lanes go together.
    together: Option<(Vec<usize>, Vec<usize>)>,
    /// Where variables must be where the loop is left, if its turns are written out.
    exits: Vec<(usize, Vec<Reg>)>,
}

/// Of an instruction of the prologue: code, constant, operands, components, strides.
type Key = (Code, u32, [Reg; 3], u16, u8);

/// Instructions and what is known of registers: what is put back when a try fails.
#[derive(Clone, Debug, Default)]
pub(crate) struct State {
    pub(crate) prologue: Vec<VirtualOp>,
    pub(crate) ops: Vec<VirtualOp>,
    /// Per register: the first of its group and the size of the group.
    pub(crate) groups: Vec<(Reg, u32)>,
    /// Computed in the prologue.
    hoisted: Vec<bool>,
    /// The same in all lanes.
    even: Vec<bool>,
    known: HashMap<Key, Vec<Reg>>,
    /// Registers whose word is known here.
    constants: HashMap<Reg, u32>,
    variables: Vec<Variable>,
    pub(crate) loops: Vec<(usize, usize)>,
    pub(crate) counts: Vec<(usize, Span)>,
    pub(crate) looks: Vec<Look<Reg>>,
    pub(crate) events: Vec<Event<Reg>>,
}

/// Most instructions that may be made, tries included: functions that call others often grow exponentially.
const MOST_WORK: usize = 400_000;

/// Most scalars of one variable: half of the register file.
const MOST_SCALARS: usize = crate::machine::ROWS / 2;

struct Lowering<'a> {
    module: &'a Module,
    info: &'a ModuleInfo,
    stage: Stage,
    roles: &'a dyn Fn(&str) -> Option<Purpose>,
    state: State,
    globals: HashMap<Handle<naga::GlobalVariable>, Item>,
    mask: Option<Reg>,
    /// What follows in this block is never reached.
    dead: bool,
    enclosing: Vec<Enclosing>,
    discarded: usize,
    /// Functions that discard.
    discarding: HashSet<Handle<Function>>,
    /// Variables that differ between lanes although they were believed not to.
    uneven: BTreeSet<usize>,
    found: BTreeSet<usize>,
    /// Lanes leave a loop one by one that was believed to be left by all together.
    apart: bool,
    work: usize,
    depth: usize,
    trace: bool,
    /// How many turns of loops are written out.
    turns: usize,
    /// Whether something was picked by an index that is known here.
    indexed: bool,
    layout: Layout,
    /// Words of constants that lie in the memory of the uniforms → the first of them there.
    pool: HashMap<Vec<u32>, usize>,
}

/// Lowers the entry point of the module's only stage. `roles` tells what a private global stands for.
pub(crate) fn lower(
    module: &Module,
    info: &ModuleInfo,
    stage: Stage,
    roles: &dyn Fn(&str) -> Option<Purpose>,
    trace: bool,
) -> Result<Lowered, Refused> {
    // Loops that are written out may need more registers than there are.
    for turns in flow::unroll::TURNS {
        match lower_with(module, info, stage, roles, (trace, turns)) {
            Err(refused) if refused.lacks_registers => {}
            done => return done,
        }
    }
    lower_with(module, info, stage, roles, (trace, 0))
}

fn lower_with(
    module: &Module,
    info: &ModuleInfo,
    stage: Stage,
    roles: &dyn Fn(&str) -> Option<Purpose>,
    (trace, turns): (bool, usize),
) -> Result<Lowered, Refused> {
    let lowering = Lowering {
        module,
        info,
        stage,
        roles,
        state: State::default(),
        globals: HashMap::new(),
        mask: None,
        dead: false,
        enclosing: Vec::new(),
        discarded: 0,
        discarding: HashSet::new(),
        uneven: BTreeSet::new(),
        found: BTreeSet::new(),
        apart: false,
        work: 0,
        depth: 0,
        trace,
        turns,
        indexed: false,
        layout: Layout::default(),
        pool: HashMap::new(),
    };
    lowering.program()
}
