// The way round a circle, step by step: the registers that all arcs share in which F decides.
//
//   0 judge    the sweep looks where the arc is; what the method asks for there is kept, an axis each
//   1 move     F <- F - 2c + 1, c <- c - 1 (towards zero)  or  F + 2c + 1, c <- c + 1 (away), of one axis
//              or of both; the counters take the pulses
//
// In the last quadrant an axis that stands is not fed, the other one is; when both stand, what an end
// point off the circle still lacks is stepped out, x first. CX and CY are the magnitudes of the moving
// point. F may wrap once an axis stands: it decides nothing any more.
module walk #(
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
    // what a judging step sees: F, the coordinate that is fed towards zero, the one that is fed away
    // from it; and what the method asks for there
    output wire [N-1:0] o_towards,
    output wire [N-1:0] o_away,
    input  wire         i_feeds_towards,
    input  wire         i_feeds_away,
    // pulses of this clock, and their directions
    output wire [1:0]   o_pulse,
    output wire [1:0]   o_negative,
    output wire         o_done,
    // registers
    output reg          o_beat,
    output reg          o_due_x,
    output reg          o_due_y,
    output reg  [N+1:0] o_f,
    output reg  [N-1:0] o_cx,
    output reg  [N-1:0] o_cy,
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
    localparam JUDGE = 1'b0, MOVE = 1'b1;

    wire is_done;
    wire judges    = o_beat == JUDGE & i_en & ~is_done;
    wire x_is_zero = o_cx == 0;
    wire y_is_zero = o_cy == 0;

    // A quadrant that is entered by this look is judged already: what was fed away from zero is fed
    // towards it there.
    wire crosses      = ~o_last & (o_towards_is_y ? y_is_zero & ~x_is_zero : x_is_zero & ~y_is_zero);
    wire towards_is_y = o_towards_is_y ^ crosses;

    assign o_towards = towards_is_y ? o_cy : o_cx;
    assign o_away    = towards_is_y ? o_cx : o_cy;

    // Move.
    wire both_stand = o_stands_x & o_stands_y;
    wire moves_x    = both_stand ? ~o_at_end_x : ~o_stands_x & (o_stands_y | o_due_x);
    wire moves_y    = both_stand ? o_at_end_x : ~o_stands_y & (o_stands_x | o_due_y);

    assign o_pulse    = {moves_y, moves_x} & {2{o_beat == MOVE}};
    assign o_negative = {o_ny, o_nx};
    assign o_done     = o_beat == JUDGE & is_done;

    wire [N-1:0] cx_next = o_cx + {{(N-1){o_shrinks_x}}, 1'b1};
    wire [N-1:0] cy_next = o_cy + {{(N-1){o_shrinks_y}}, 1'b1};
    // -2c + 1 is ~(2(c - 1))
    wire [N+1:0] change_x = o_shrinks_x ? ~{1'b0, cx_next, 1'b0} : {1'b0, o_cx, 1'b1};
    wire [N+1:0] change_y = o_shrinks_y ? ~{1'b0, cy_next, 1'b0} : {1'b0, o_cy, 1'b1};

    sweep #(.N(N)) sweep (
        .i_clk         (i_clk),
        .i_rst         (i_rst),
        .i_load        (i_load),
        .i_quadrant    (i_quadrant),
        .i_crossings   (i_crossings),
        .i_cw          (i_cw),
        .i_jex         (i_jex),
        .i_jey         (i_jey),
        .i_look        (judges),
        .i_x_is_zero   (x_is_zero),
        .i_y_is_zero   (y_is_zero),
        .i_px          (o_pulse[0]),
        .i_nx          (o_nx),
        .i_py          (o_pulse[1]),
        .i_ny          (o_ny),
        .o_done        (is_done),
        .o_quadrant    (o_quadrant),
        .o_crossings   (o_crossings),
        .o_cw          (o_cw),
        .o_jex         (o_jex),
        .o_jey         (o_jey),
        .o_last        (o_last),
        .o_towards_is_y(o_towards_is_y),
        .o_feeds_nx    (o_feeds_nx),
        .o_feeds_ny    (o_feeds_ny),
        .o_at_end_x    (o_at_end_x),
        .o_at_end_y    (o_at_end_y),
        .o_stands_x    (o_stands_x),
        .o_stands_y    (o_stands_y),
        .o_stepping_out(o_stepping_out),
        .o_nx          (o_nx),
        .o_ny          (o_ny),
        .o_shrinks_x   (o_shrinks_x),
        .o_shrinks_y   (o_shrinks_y)
    );

    always @(posedge i_clk)
        if (i_rst) begin
            o_beat  <= JUDGE;
            o_due_x <= 1'b0;
            o_due_y <= 1'b0;
            o_f     <= {(N+2){1'b0}};
            o_cx    <= {N{1'b0}};
            o_cy    <= {N{1'b0}};
        end else if (i_load) begin
            o_beat  <= JUDGE;
            o_due_x <= 1'b0;
            o_due_y <= 1'b0;
            o_f     <= {(N+2){1'b0}};
            o_cx    <= i_cx;
            o_cy    <= i_cy;
        end else if (o_beat == MOVE) begin
            o_beat <= JUDGE;
            o_f    <= o_f + (change_x & {(N+2){moves_x}}) + (change_y & {(N+2){moves_y}});
            if (moves_x) o_cx <= cx_next;
            if (moves_y) o_cy <= cy_next;
        end else if (judges) begin
            o_beat  <= MOVE;
            o_due_x <= towards_is_y ? i_feeds_away : i_feeds_towards;
            o_due_y <= towards_is_y ? i_feeds_towards : i_feeds_away;
        end
endmodule
