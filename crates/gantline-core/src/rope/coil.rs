//! Rope wound on a drum: with which strain every part of it lies there, and in which layer.
//!
//! Rope winds up stretched and takes its strain along; it comes off again in the reverse order, each part at the strain
//! with which it was wound. Lengths here are of wound, that is stretched, rope, counted from the start and positive
//! where rope has been wound up since.

use serde::{Deserialize, Serialize};

/// Rope of one strain on a drum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Piece {
    /// Where it begins [m]; it ends where the next begins, or where the winding ends.
    pub from: f64,
    /// Its strain.
    pub strain: f64,
}

/// Strains that differ by less are one: as a share of the strain, and of the length.
const SAME_SHARE: f64 = 1e-4;
const SAME: f64 = 1e-9;
/// A piece shorter than this [m] is one with what comes on next, whatever its strain: a drum that rings under its brake
/// would leave hundreds.
const SHORT: f64 = 1e-9;
/// A coil remembers at most so many pieces; then neighbours that are most alike are taken together, two by two.
pub const MOST_PIECES: usize = 1024;

/// What a drum remembers of the rope on it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Coil {
    /// Strain of the rope that was on the drum at the start.
    pub laid: f64,
    /// How much has been wound up since the start [m].
    pub wound: f64,
    /// How much unstretched rope had been let go when it was that [m].
    pub let_go: f64,
    /// Rope wound up since the start, the innermost first.
    pub pieces: Vec<Piece>,
    /// True while the drum winds up: then what passes has the strain of the rope that comes.
    pub winds: bool,
    /// True where the rope outside is longer than unstretched. A damped one may then carry nothing, and goes on to wind
    /// up with its strain: what is wound may not jump as it goes slack.
    #[serde(default)]
    pub is_stretched: bool,
}

impl Coil {
    /// A drum at the start, with rope of the strain `laid` on it.
    pub fn new(laid: f64) -> Self {
        Self {
            laid,
            wound: 0.0,
            let_go: 0.0,
            pieces: Vec::with_capacity(MOST_PIECES),
            winds: false,
            is_stretched: false,
        }
    }

    /// Takes over another coil; does not allocate once there has been room.
    pub fn copy_from(&mut self, other: &Self) {
        (self.laid, self.wound, self.let_go) = (other.laid, other.wound, other.let_go);
        (self.winds, self.is_stretched) = (other.winds, other.is_stretched);
        self.pieces.clear();
        self.pieces.reserve_exact(MOST_PIECES);
        self.pieces.extend_from_slice(&other.pieces);
    }

    /// Strain of the rope that passes where `wound` [m] lie on the drum; that of the rope outside is `outside`.
    pub fn passing(&self, wound: f64, outside: f64) -> f64 {
        if self.winds {
            return outside;
        }
        let below = self.pieces.partition_point(|piece| piece.from < wound);
        below.checked_sub(1).map_or(self.laid, |index| self.pieces[index].strain)
    }

    /// Unstretched rope let go where `wound` [m] lie on the drum and it has paid out since it last remembered [m].
    pub fn let_go_at(&self, wound: f64) -> f64 {
        let (mut let_go, mut from) = (self.let_go, self.wound);
        for piece in self.pieces.iter().rev() {
            let_go += (from - piece.from.max(wound)) / (1.0 + piece.strain);
            if piece.from <= wound {
                return let_go;
            }
            from = piece.from;
        }
        let_go + (from - wound) / (1.0 + self.laid)
    }

    /// Brings the coil to `wound` [m], where rope of the mean strain `strain` has come on if that is more than before;
    /// returns by how much ½ ε² times its unstretched length has grown [m]: what it holds, over EA.
    pub fn bring_to(&mut self, wound: f64, strain: f64) -> f64 {
        let before = std::mem::replace(&mut self.wound, wound);
        if wound > before { self.wind(before, wound, strain) } else { -self.unwind(before, wound) }
    }

    /// Forgets what came on last where that is no more than `length` [m]: what lies below passes there.
    pub fn forget_last(&mut self, length: f64) {
        while self.pieces.last().is_some_and(|last| self.wound - last.from <= length) {
            self.pieces.pop();
        }
    }

    fn wind(&mut self, from: f64, to: f64, strain: f64) -> f64 {
        let gained = held(to - from, strain);
        let is_one = |last: &&mut Piece| {
            from - last.from < SHORT || (last.strain - strain).abs() <= SAME_SHARE * strain + SAME
        };
        if let Some(last) = self.pieces.last_mut().filter(is_one) {
            let apart = held(from - last.from, last.strain) + gained;
            last.strain = together([from - last.from, to - from], [last.strain, strain]);
            return held(to - last.from, last.strain) - (apart - gained);
        }
        let lost = if self.pieces.len() == MOST_PIECES { self.coarsen(from) } else { 0.0 };
        self.pieces.push(Piece { from, strain });
        gained - lost
    }

    /// Takes neighbours together, the coil ending at `end`: of all pairs the half that this moves the least, so that what
    /// was wound long ago is kept as well as what came on last. Returns what that loses.
    fn coarsen(&mut self, end: f64) -> f64 {
        let last = self.pieces.len() - 1;
        let mut moved = [0.0; MOST_PIECES];
        for (index, moved) in moved[..last].iter_mut().enumerate() {
            *moved = self.moved_by_one(index, end);
        }
        let (_, &mut bound, _) = moved[..last].select_nth_unstable_by(last / 2, f64::total_cmp);
        let (mut lost, mut kept, mut index) = (0.0, 0, 0);
        while index <= last {
            let mut piece = self.pieces[index];
            if index < last && self.moved_by_one(index, end) <= bound {
                let (lengths, strains) = self.pair(index, end);
                piece.strain = together(lengths, strains);
                lost += held(lengths[0], strains[0]) + held(lengths[1], strains[1])
                    - held(lengths[0] + lengths[1], piece.strain);
                index += 1;
            }
            self.pieces[kept] = piece;
            (kept, index) = (kept + 1, index + 1);
        }
        self.pieces.truncate(kept);
        lost
    }

    /// Lengths [m] and strains of a piece and the next, the coil ending at `end`.
    fn pair(&self, index: usize, end: f64) -> ([f64; 2], [f64; 2]) {
        let [one, other] = [self.pieces[index], self.pieces[index + 1]];
        let stop = self.pieces.get(index + 2).map_or(end, |piece| piece.from);
        ([other.from - one.from, stop - other.from], [one.strain, other.strain])
    }

    /// By how much what has been let go would differ between the ends of a piece and the next [m], were they one.
    fn moved_by_one(&self, index: usize, end: f64) -> f64 {
        let ([one, other], [first, second]) = self.pair(index, end);
        one * other / (one + other) * (first - second).abs()
    }

    /// Lets rope off from `from` down to `to`; returns what it held.
    fn unwind(&mut self, mut from: f64, to: f64) -> f64 {
        let mut lost = 0.0;
        while let Some(piece) = self.pieces.last().copied() {
            lost += held(from - piece.from.max(to), piece.strain);
            if piece.from < to {
                return lost;
            }
            from = piece.from;
            self.pieces.pop();
        }
        lost + held(from - to, self.laid)
    }
}

/// ½ ε² times the unstretched length of wound rope [m].
fn held(length: f64, strain: f64) -> f64 {
    0.5 * strain * strain * length / (1.0 + strain)
}

/// The strain of two pieces together that leaves their unstretched length as it is.
fn together(lengths: [f64; 2], strains: [f64; 2]) -> f64 {
    let unstretched = lengths[0] / (1.0 + strains[0]) + lengths[1] / (1.0 + strains[1]);
    if unstretched > 0.0 { (lengths[0] + lengths[1]) / unstretched - 1.0 } else { strains[1] }
}

/// Part of a turn in which rope climbs from one layer onto the next.
const CLIMB: f64 = 0.5;

/// No drum has so many layers. Where a step that is only tried throws a drum far away, what it would have wound is not
/// counted layer by layer for ever.
pub const MOST_LAYERS: usize = 1000;

/// Steps of Newton's method for what a drum has turned; it takes about one for each layer.
const MOST_STEPS: usize = 100;

/// Layers of rope on a drum. Their radii grow by steps; from one layer to the next the radius grows within half a turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layers {
    /// Pitch radius of the first layer [m].
    pub radius: f64,
    /// By how much that of the next is larger, as a share of it.
    pub growth: f64,
    /// Turns in a full layer.
    pub turns: f64,
    /// Turns on the drum at the start.
    pub start: f64,
}

impl Layers {
    /// Turns on the drum where it has turned by so much rope on the first layer [m] since the start.
    pub fn turns_at(&self, turned: f64) -> f64 {
        self.start + turned / (std::f64::consts::TAU * self.radius)
    }

    /// Radius of the rope that comes on there, over that of the first layer.
    pub fn ratio(&self, turned: f64) -> f64 {
        let turns = self.turns_at(turned);
        1.0 + self.growth * self.sum(turns, |over| over.clamp(0.0, 1.0))
    }

    /// By how much that ratio grows with what the drum turns [1/m].
    pub fn slope(&self, turned: f64) -> f64 {
        let climbs = self.sum(self.turns_at(turned), |over| if over < 1.0 { 1.0 } else { 0.0 });
        self.growth * climbs / (CLIMB * std::f64::consts::TAU * self.radius)
    }

    /// Rope wound up since the start, where the drum has turned by so much rope on the first layer [m].
    pub fn wound(&self, turned: f64) -> f64 {
        let climbed = |over: f64| if over < 1.0 { 0.5 * over * over } else { over - 0.5 };
        let extra = |turns: f64| CLIMB * self.sum(turns, climbed);
        let more = extra(self.turns_at(turned)) - extra(self.start);
        turned + std::f64::consts::TAU * self.radius * self.growth * more
    }

    /// What the drum has turned, as rope on the first layer [m], where so much rope has been wound up since the start.
    pub fn turned_at(&self, wound: f64) -> f64 {
        let mut turned = wound;
        for _ in 0..MOST_STEPS {
            let step = (wound - self.wound(turned)) / self.ratio(turned);
            turned += step;
            // Each layer is wider than the one below, so that Newton's method comes from above and cannot miss.
            if step.abs() <= f64::EPSILON * turned.abs() {
                break;
            }
        }
        turned
    }

    /// Sum over the climbs that have begun at `turns`, of how far over them the rope is, in climbs.
    fn sum(&self, turns: f64, each: impl Fn(f64) -> f64) -> f64 {
        let over = |layer: usize| (turns - layer as f64 * self.turns) / CLIMB + 0.5;
        (1..=MOST_LAYERS).map(over).take_while(|over| *over > 0.0).map(each).sum()
    }
}
