/* The yardstick: a program for the lifts E(n) and nothing else, written out from the equations of motion.
 *
 * Coordinates: yaw of the frame ψ, drop s_i of each moving sheave below the fixed axles, position p and unit
 * quaternion r of the load; 1 + n + 6 velocities. In these the mass matrix is constant and diagonal (the load's
 * angular velocity ω in body axes):
 *
 *     P_i = (x_i cos ψ, x_i sin ψ, z - s_i)       Q_i = p + R u_i       d = (Q_i - P_i) / l_i
 *     T_i = max(0, k_i (l_i - L_i + τ l̇_i))       T_eq = max(0, k_eq Σ (2 (s_i - s_0) + τ 2 ṡ_i))
 *
 *     (I_f + Σ m x_i²) ψ̈ = Σ x_i T_i (d_y cos ψ - d_x sin ψ) - b ψ̇
 *     m s̈_i = m g - 2 T_eq - T_i d_z
 *     M p̈ = -Σ T_i d - M g e_z
 *     J ω̇ = -Σ u_i × T_i Rᵀ d - ω × J ω,     ṙ = ½ r ω
 *
 * Classical Runge-Kutta method of order four, fixed step.
 */

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { YAW, LOAD, TURN = LOAD + 3, DROPS = TURN + 4 }; /* positions; velocities follow, the turn has three */
enum { YAW_RATE, LOAD_RATE, TURN_RATE = LOAD_RATE + 3, DROP_RATES = TURN_RATE + 3 };

typedef struct {
    double frame_inertia, yaw_damping, sheave_mass, axle_height, start_drop;
    double load_mass, load_inertia[3], load_height, lug_height;
    double equalizing_stiffness, damping_time, gravity;
} Lift;

typedef struct {
    int n;
    const Lift *lift;
    const double *x, *lug_x, *lug_y, *length, *stiffness;
    double yaw_inertia;
} System;

/* Derivative of the state (positions, then velocities); the tensions on the way. */
static void derivative(const System *system, const double *restrict state, double *restrict rate,
                       double *restrict tension)
{
    const Lift lift = *system->lift;
    const int n = system->n;
    const double *restrict x = system->x, *restrict lug_x = system->lug_x, *restrict lug_y = system->lug_y;
    const double *restrict length = system->length, *restrict stiffness = system->stiffness;
    const double *restrict velocity = state + DROPS + n;
    const double *restrict drop = state + DROPS, *restrict drop_rate = velocity + DROP_RATES;
    double *restrict acceleration = rate + DROPS + n;

    const double cosine = cos(state[YAW]), sine = sin(state[YAW]), yaw_rate = velocity[YAW_RATE];
    const double px = state[LOAD], py = state[LOAD + 1], pz = state[LOAD + 2];
    const double vx = velocity[LOAD_RATE], vy = velocity[LOAD_RATE + 1], vz = velocity[LOAD_RATE + 2];
    const double a = state[TURN], b = state[TURN + 1], c = state[TURN + 2], d = state[TURN + 3];
    const double wx = velocity[TURN_RATE], wy = velocity[TURN_RATE + 1], wz = velocity[TURN_RATE + 2];
    const double r00 = 1 - 2 * (c * c + d * d), r01 = 2 * (b * c - a * d), r02 = 2 * (b * d + a * c);
    const double r10 = 2 * (b * c + a * d), r11 = 1 - 2 * (b * b + d * d), r12 = 2 * (c * d - a * b);
    const double r20 = 2 * (b * d - a * c), r21 = 2 * (c * d + a * b), r22 = 1 - 2 * (b * b + c * c);

    double stretch = 0, stretch_rate = 0;
#pragma omp simd reduction(+ : stretch, stretch_rate)
    for (int i = 0; i < n; i++) {
        stretch += 2 * (drop[i] - lift.start_drop);
        stretch_rate += 2 * drop_rate[i];
    }
    const double equalizing =
        fmax(0, lift.equalizing_stiffness * (stretch + lift.damping_time * stretch_rate));
    tension[n] = equalizing;

    const double uz = lift.lug_height, base = lift.gravity - 2 * equalizing / lift.sheave_mass;
    double fx = 0, fy = 0, fz = 0, mx = 0, my = 0, mz = 0, yaw_torque = 0;
#pragma omp simd reduction(+ : fx, fy, fz, mx, my, mz, yaw_torque)
    for (int i = 0; i < n; i++) {
        const double ux = lug_x[i], uy = lug_y[i];
        const double ox = r00 * ux + r01 * uy + r02 * uz;
        const double oy = r10 * ux + r11 * uy + r12 * uz;
        const double oz = r20 * ux + r21 * uy + r22 * uz;
        const double dx = px + ox - x[i] * cosine;
        const double dy = py + oy - x[i] * sine;
        const double dz = pz + oz - lift.axle_height + drop[i];
        const double tx = wy * uz - wz * uy, ty = wz * ux - wx * uz, tz = wx * uy - wy * ux;
        const double ex = vx + r00 * tx + r01 * ty + r02 * tz + x[i] * sine * yaw_rate;
        const double ey = vy + r10 * tx + r11 * ty + r12 * tz - x[i] * cosine * yaw_rate;
        const double ez = vz + r20 * tx + r21 * ty + r22 * tz + drop_rate[i];
        const double span = sqrt(dx * dx + dy * dy + dz * dz), inverse = 1 / span;
        const double span_rate = (dx * ex + dy * ey + dz * ez) * inverse;
        const double force =
            fmax(0, stiffness[i] * (span - length[i] + lift.damping_time * span_rate));
        const double gx = force * inverse * dx, gy = force * inverse * dy, gz = force * inverse * dz;
        tension[i] = force;
        fx += gx;
        fy += gy;
        fz += gz;
        const double bx = r00 * gx + r10 * gy + r20 * gz;
        const double by = r01 * gx + r11 * gy + r21 * gz;
        const double bz = r02 * gx + r12 * gy + r22 * gz;
        mx += uy * bz - uz * by;
        my += uz * bx - ux * bz;
        mz += ux * by - uy * bx;
        yaw_torque += x[i] * (gy * cosine - gx * sine);
        rate[DROPS + i] = drop_rate[i];
        acceleration[DROP_RATES + i] = base - gz / lift.sheave_mass;
    }

    const double jx = lift.load_inertia[0], jy = lift.load_inertia[1], jz = lift.load_inertia[2];
    rate[YAW] = yaw_rate;
    rate[LOAD] = vx;
    rate[LOAD + 1] = vy;
    rate[LOAD + 2] = vz;
    rate[TURN] = 0.5 * (-b * wx - c * wy - d * wz);
    rate[TURN + 1] = 0.5 * (a * wx + c * wz - d * wy);
    rate[TURN + 2] = 0.5 * (a * wy + d * wx - b * wz);
    rate[TURN + 3] = 0.5 * (a * wz + b * wy - c * wx);
    acceleration[YAW_RATE] = (yaw_torque - lift.yaw_damping * yaw_rate) / system->yaw_inertia;
    acceleration[LOAD_RATE] = -fx / lift.load_mass;
    acceleration[LOAD_RATE + 1] = -fy / lift.load_mass;
    acceleration[LOAD_RATE + 2] = -fz / lift.load_mass - lift.gravity;
    acceleration[TURN_RATE] = (-mx - (jz - jy) * wy * wz) / jx;
    acceleration[TURN_RATE + 1] = (-my - (jx - jz) * wz * wx) / jy;
    acceleration[TURN_RATE + 2] = (-mz - (jy - jx) * wx * wy) / jz;
}

/* Sling tensions and the equalizing rope's, n + 1 to a row, at 0, pace * step, ..., `samples` rows.
 * Returns 0, or 1 where there is no memory. */
int run(int n, const Lift *lift, const double *x, const double *lug_x, const double *lug_y, const double *length,
        const double *stiffness, double step, int pace, int samples, double *out)
{
    System system = {n, lift, x, lug_x, lug_y, length, stiffness, lift->frame_inertia};
    for (int i = 0; i < n; i++)
        system.yaw_inertia += lift->sheave_mass * x[i] * x[i];

    const int size = (DROPS + n) + (DROP_RATES + n);
    double *memory = calloc((size_t)(6 * size + n + 1), sizeof(double));
    if (!memory)
        return 1;
    double *state = memory, *trial = state + size, *k1 = trial + size, *k2 = k1 + size, *k3 = k2 + size,
           *k4 = k3 + size, *tension = k4 + size;
    state[LOAD + 2] = lift->load_height;
    state[TURN] = 1;
    for (int i = 0; i < n; i++)
        state[DROPS + i] = lift->start_drop;

    for (int sample = 0; sample < samples; sample++) {
        for (int count = 0; count < pace; count++) {
            derivative(&system, state, k1, tension);
            if (count == 0) {
                memcpy(out + (size_t)sample * (size_t)(n + 1), tension, (size_t)(n + 1) * sizeof(double));
                if (sample == samples - 1)
                    break;
            }
            for (int j = 0; j < size; j++)
                trial[j] = state[j] + step / 2 * k1[j];
            derivative(&system, trial, k2, tension);
            for (int j = 0; j < size; j++)
                trial[j] = state[j] + step / 2 * k2[j];
            derivative(&system, trial, k3, tension);
            for (int j = 0; j < size; j++)
                trial[j] = state[j] + step * k3[j];
            derivative(&system, trial, k4, tension);
            for (int j = 0; j < size; j++)
                state[j] += step / 6 * (k1[j] + 2 * (k2[j] + k3[j]) + k4[j]);
            double norm = 0;
            for (int j = TURN; j < TURN + 4; j++)
                norm += state[j] * state[j];
            for (int j = TURN; j < TURN + 4; j++)
                state[j] /= sqrt(norm);
        }
    }
    free(memory);
    return 0;
}
