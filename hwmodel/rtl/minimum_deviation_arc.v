// Circular arc by minimum deviation: two clocks a step.
//
// Of the steps towards zero (F_t = F - 2t + 1), away from it (F_a = F + 2a + 1) and both
// (F_b = F_t + 2a + 1) the one with the smallest |F| is taken, both before a single one. As
// F_t < F_b < F_a, one motion is not due where the sum of the other and of both says so by its sign:
// away alone where F_a + F_b < 0, towards zero alone where F_t + F_b > 0. Half of each sum does.
module minimum_deviation_arc #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // pulse source: begins a step, when none is under way
    input  wire         i_en,
    // command: the registers' first contents
    input  wire         i_load,
    input  wire [N-1:0] i_cx,
    input  wire [N-1:0] i_cy,
    input  wire [1:0]   i_quadrant,
    input  wire [2:0]   i_crossings,
    input  wire         i_cw,
    input  wire [N+1:0] i_jex,
    input  wire [N+1:0] i_jey,
    // pulses of this clock, and their directions
    output wire [1:0]   o_pulse,
    output wire [1:0]   o_negative,
    output wire         o_done,
    // registers
    output wire         o_beat,
    output wire         o_due_x,
    output wire         o_due_y,
    output wire [N+1:0] o_f,
    output wire [N-1:0] o_cx,
    output wire [N-1:0] o_cy,
    // registers of the sweep
    output wire [1:0]   o_quadrant,
    output wire [2:0]   o_crossings,
    output wire         o_cw,
    output wire [N+1:0] o_jex,
    output wire [N+1:0] o_jey,
    output wire         o_last,
    output wire         o_towards_is_y,
    output wire         o_feeds_nx,
    output wire         o_feeds_ny,
    output wire         o_at_end_x,
    output wire         o_at_end_y,
    output wire         o_stands_x,
    output wire         o_stands_y,
    output wire         o_stepping_out,
    output wire         o_nx,
    output wire         o_ny,
    output wire         o_shrinks_x,
    output wire         o_shrinks_y
);
    wire [N-1:0] towards, away;

    wire [N+2:0] level         = {o_f[N+1], o_f} + {3'b000, away} - {3'b000, towards};
    wire [N+2:0] upper         = level + {3'b000, away} + 1'b1;
    wire [N+2:0] lower         = level - {3'b000, towards} + 1'b1;
    wire         feeds_towards = ~upper[N+2];
    wire         feeds_away    = lower[N+2];

    walk #(.N(N)) walk (
        .i_clk          (i_clk),
        .i_rst          (i_rst),
        .i_en           (i_en),
        .i_load         (i_load),
        .i_cx           (i_cx),
        .i_cy           (i_cy),
        .i_quadrant     (i_quadrant),
        .i_crossings    (i_crossings),
        .i_cw           (i_cw),
        .i_jex          (i_jex),
        .i_jey          (i_jey),
        .o_towards      (towards),
        .o_away         (away),
        .i_feeds_towards(feeds_towards),
        .i_feeds_away   (feeds_away),
        .o_pulse        (o_pulse),
        .o_negative     (o_negative),
        .o_done         (o_done),
        .o_beat         (o_beat),
        .o_due_x        (o_due_x),
        .o_due_y        (o_due_y),
        .o_f            (o_f),
        .o_cx           (o_cx),
        .o_cy           (o_cy),
        .o_quadrant     (o_quadrant),
        .o_crossings    (o_crossings),
        .o_cw           (o_cw),
        .o_jex          (o_jex),
        .o_jey          (o_jey),
        .o_last         (o_last),
        .o_towards_is_y (o_towards_is_y),
        .o_feeds_nx     (o_feeds_nx),
        .o_feeds_ny     (o_feeds_ny),
        .o_at_end_x     (o_at_end_x),
        .o_at_end_y     (o_at_end_y),
        .o_stands_x     (o_stands_x),
        .o_stands_y     (o_stands_y),
        .o_stepping_out (o_stepping_out),
        .o_nx           (o_nx),
        .o_ny           (o_ny),
        .o_shrinks_x    (o_shrinks_x),
        .o_shrinks_y    (o_shrinks_y)
    );
endmodule
