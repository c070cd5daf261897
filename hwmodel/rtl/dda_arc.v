// Circular arc by digital integration, the textbook's circuit: both integrators add in the same
// clock, each pulse corrects the integrand that follows its axis by i_unit = 2^Q.
//
//   0 add      SX <- JRx + JVx, SY <- JRy + JVy, carries and all
//   1 correct  the remainders take the sums, the carries are the pulses: integrands and end
//              counters take them
//
// A carry that reached the integrands in its own clock would have two adders in a row; the sum
// registers between them let the clock run more than twice as fast.
//
// JVx holds |y| and JVy holds |x|. The path exceeds one pulse; dda_centred_arc does not.
module dda_arc #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // pulse source: begins a cycle, when none is under way
    input  wire         i_en,
    // command: the registers' first contents
    input  wire         i_load,
    input  wire [N-1:0] i_jvx,
    input  wire [N-1:0] i_jvy,
    input  wire [N-1:0] i_preset,
    input  wire [N-1:0] i_unit,
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
    output reg          o_beat,
    output reg  [N-1:0] o_unit,
    output reg  [N-1:0] o_jvx,
    output reg  [N-1:0] o_jvy,
    output reg  [N-1:0] o_jrx,
    output reg  [N-1:0] o_jry,
    output reg  [N:0]   o_sumx,
    output reg  [N:0]   o_sumy,
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
    localparam ADD = 1'b0, CORRECT = 1'b1;

    wire is_last;
    // Without the end counters' zero detectors: what is added after the end is not used.
    wire add = o_beat == ADD & i_en;
    wire px  = o_beat == CORRECT & (o_stepping_out ? ~o_at_end_x : o_sumx[N] & ~o_stands_x);
    wire py  = o_beat == CORRECT & (o_stepping_out ? ~o_at_end_y : o_sumy[N] & ~o_stands_y);

    assign o_pulse    = {py, px};
    assign o_negative = {o_ny, o_nx};
    assign o_done     = o_beat == ADD & is_last;

    // a - b is a + ~b + 1
    wire [N-1:0] jvy_next = o_jvy + (o_unit ^ {N{o_shrinks_x}}) + {{(N-1){1'b0}}, o_shrinks_x};
    wire [N-1:0] jvx_next = o_jvx + (o_unit ^ {N{o_shrinks_y}}) + {{(N-1){1'b0}}, o_shrinks_y};

    sweep #(.N(N)) sweep (
        .i_clk         (i_clk),
        .i_rst         (i_rst),
        .i_load        (i_load),
        .i_quadrant    (i_quadrant),
        .i_crossings   (i_crossings),
        .i_cw          (i_cw),
        .i_jex         (i_jex),
        .i_jey         (i_jey),
        .i_look        (add),
        .i_x_is_zero   (o_jvy == 0),
        .i_y_is_zero   (o_jvx == 0),
        .i_px          (px),
        .i_nx          (o_nx),
        .i_py          (py),
        .i_ny          (o_ny),
        .o_done        (is_last),
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
            o_beat <= ADD;
            o_unit <= {N{1'b0}};
            o_jvx  <= {N{1'b0}};
            o_jvy  <= {N{1'b0}};
            o_jrx  <= {N{1'b0}};
            o_jry  <= {N{1'b0}};
            o_sumx <= {(N+1){1'b0}};
            o_sumy <= {(N+1){1'b0}};
        end else if (i_load) begin
            o_beat <= ADD;
            o_unit <= i_unit;
            o_jvx  <= i_jvx;
            o_jvy  <= i_jvy;
            o_jrx  <= i_preset;
            o_jry  <= i_preset;
            o_sumx <= {(N+1){1'b0}};
            o_sumy <= {(N+1){1'b0}};
        end else begin
            if (add) begin
                o_beat <= ~is_last;
                o_sumx <= {1'b0, o_jrx} + {1'b0, o_jvx};
                o_sumy <= {1'b0, o_jry} + {1'b0, o_jvy};
            end
            if (o_beat == CORRECT) begin
                o_beat <= ADD;
                if (~o_stepping_out & ~o_stands_x) o_jrx <= o_sumx[N-1:0];
                if (~o_stepping_out & ~o_stands_y) o_jry <= o_sumy[N-1:0];
            end
            if (px) o_jvy <= jvy_next;
            if (py) o_jvx <= jvx_next;
        end
endmodule
