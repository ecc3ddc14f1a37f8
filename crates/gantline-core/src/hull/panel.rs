//! One triangle and the plane: its corners' heights, and the triangles that its part below is made of.

use glam::DVec3;

/// A plane by the height h(x) = n·x + d over it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// n, unit vector upwards.
    pub normal: DVec3,
    /// d, height of the origin above the plane [m].
    pub height: f64,
}

impl Plane {
    /// Height of a point above the plane [m].
    #[inline]
    pub fn above(&self, point: DVec3) -> f64 {
        self.normal.dot(point) + self.height
    }
}

/// A triangle with the heights of its corners.
#[derive(Debug, Clone, Copy)]
pub struct Panel {
    /// Corners [m], counter-clockwise from outside.
    pub corners: [DVec3; 3],
    /// Their heights above the plane [m].
    pub heights: [f64; 3],
    /// Area times outward unit normal [m²].
    pub area: DVec3,
}

/// What of a panel lies below the plane.
#[derive(Debug, Clone, Copy)]
pub struct Below {
    /// Up to two triangles.
    pub parts: [Panel; 2],
    /// How many.
    pub count: usize,
    /// Where the panel meets the plane, so that what is below lies to the left from outside; none where it does not.
    pub waterline: Option<[DVec3; 2]>,
}

impl Panel {
    /// What lies below; a corner in the plane is not below.
    pub fn below(&self) -> Below {
        let wet = self.heights.map(|height| height < 0.0);
        let whole = Below { parts: [*self; 2], count: 1, waterline: None };
        match wet {
            [true, true, true] => whole,
            [false, false, false] => Below { count: 0, ..whole },
            // The one corner that is on its own side comes first.
            [true, false, false] | [false, true, true] => self.cut(0),
            [false, true, false] | [true, false, true] => self.cut(1),
            [false, false, true] | [true, true, false] => self.cut(2),
        }
    }

    fn cut(&self, alone: usize) -> Below {
        let turn = [alone, (alone + 1) % 3, (alone + 2) % 3];
        let [a, b, c] = turn.map(|corner| self.corners[corner]);
        let [ha, hb, hc] = turn.map(|corner| self.heights[corner]);
        // Shares of the edges a–b and a–c up to the plane.
        let (tb, tc) = (ha / (ha - hb), ha / (ha - hc));
        let (on_b, on_c) = (a + (b - a) * tb, a + (c - a) * tc);
        let part = |corners, heights, share: f64| Panel { corners, heights, area: self.area * share };
        if ha < 0.0 {
            let tip = part([a, on_b, on_c], [ha, 0.0, 0.0], tb * tc);
            return Below { parts: [tip; 2], count: 1, waterline: Some([on_b, on_c]) };
        }
        let parts = [
            part([on_b, b, c], [0.0, hb, hc], 1.0 - tb),
            part([on_b, c, on_c], [0.0, hc, 0.0], tb * (1.0 - tc)),
        ];
        Below { parts, count: 2, waterline: Some([on_c, on_b]) }
    }
}
