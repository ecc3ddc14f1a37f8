//! What friction does in an equilibrium: nothing, what it can, or all one way, which bounds it.

use glam::DVec3;

/// What friction of sheaves does.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Sheaves {
    /// Nothing: one tension on both sides, the middle of what they may hold.
    #[default]
    Ideal,
    /// All slip towards the end of their ropes' routes (1) or towards the start (−1).
    Slip(f64),
    /// They hold where the state has them, each with no more than its friction.
    Held,
}

/// What friction of contacts does.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Contacts {
    /// Nothing: they slide freely.
    #[default]
    Free,
    /// They hold where the state has them, each with no more than its friction.
    Held,
    /// All have slid along this direction of the world, a unit vector, and friction pulls them back.
    Slid(DVec3),
}

/// What friction of sheaves and contacts does.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Losses {
    /// Of sheaves.
    pub sheaves: Sheaves,
    /// Of contacts.
    pub contacts: Contacts,
}

impl Losses {
    /// Nothing.
    pub const NONE: Self = Self { sheaves: Sheaves::Ideal, contacts: Contacts::Free };
    /// All sheaves slip towards the end of their ropes' routes; contacts slide freely.
    pub const FORWARD: Self = Self { sheaves: Sheaves::Slip(1.0), ..Self::NONE };
    /// All slip towards the start.
    pub const BACKWARD: Self = Self { sheaves: Sheaves::Slip(-1.0), ..Self::NONE };
    /// Sheaves and contacts hold where the state has them.
    pub const HELD: Self = Self { sheaves: Sheaves::Held, contacts: Contacts::Held };

    /// All contacts have slid along a direction of the world, sheaves being ideal; none where that is no direction.
    pub fn slid(direction: [f64; 3]) -> Option<Self> {
        let way = DVec3::from_array(direction).try_normalize()?;
        Some(Self { contacts: Contacts::Slid(way), ..Self::NONE })
    }

    /// What it does on the way to where this is asked for: contacts hold, since what stands in the wind or in a slack
    /// sling would slide there. What has slid in the end is where everything was held.
    pub fn on_the_way(self) -> Self {
        let sheaves = if matches!(self.contacts, Contacts::Slid(_)) { Sheaves::Held } else { self.sheaves };
        Self { sheaves, contacts: Contacts::Held }
    }
}
