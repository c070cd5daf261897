// Circular arc by digital integration, the textbook's circuit: both integrators add in the same
// clock, each pulse corrects the integrand that follows its axis by i_unit = 2^Q.
//
// JVx holds |y| and JVy holds |x|. The path exceeds one pulse; dda_centred_arc does not.
module dda_arc #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // pulse source
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
    output reg  [N-1:0] o_unit,
    output wire         o_cw,
    output reg  [N-1:0] o_jvx,
    output reg  [N-1:0] o_jvy,
    output wire [N-1:0] o_jrx,
    output wire [N-1:0] o_jry,
    output wire [1:0]   o_quadrant,
    output wire [2:0]   o_crossings,
    output wire [N+1:0] o_jex,
    output wire [N+1:0] o_jey
);
    wire         towards_is_y, nx, ny, x_stands, y_stands, stepping_out, carry_x, carry_y;
    wire         run = i_en & ~o_done;

    // When stepping out, the end counters' signs are the directions.
    wire px = run & (stepping_out ? o_jex != 0 : carry_x & ~x_stands);
    wire py = run & (stepping_out ? o_jey != 0 : carry_y & ~y_stands);
    wire sx = stepping_out ? o_jex[N+1] : nx;
    wire sy = stepping_out ? o_jey[N+1] : ny;

    assign o_pulse    = {py, px};
    assign o_negative = {sy, sx};

    // The coordinate that is fed towards zero shrinks, the other grows; stepping out may go back.
    wire         x_shrinks = ~towards_is_y ^ (sx ^ nx);
    wire         y_shrinks = towards_is_y ^ (sy ^ ny);
    wire [N-1:0] jvy_next  = px ? (x_shrinks ? o_jvy - o_unit : o_jvy + o_unit) : o_jvy;
    wire [N-1:0] jvx_next  = py ? (y_shrinks ? o_jvx - o_unit : o_jvx + o_unit) : o_jvx;

    wire accumulate = run & ~stepping_out;

    integrator #(.N(N)) integrator_x (
        .i_clk   (i_clk),
        .i_rst   (i_rst),
        .i_load  (i_load),
        .i_preset(i_preset),
        .i_en    (accumulate & ~x_stands),
        .i_jv    (o_jvx),
        .o_carry (carry_x),
        .o_jr    (o_jrx)
    );

    integrator #(.N(N)) integrator_y (
        .i_clk   (i_clk),
        .i_rst   (i_rst),
        .i_load  (i_load),
        .i_preset(i_preset),
        .i_en    (accumulate & ~y_stands),
        .i_jv    (o_jvy),
        .o_carry (carry_y),
        .o_jr    (o_jry)
    );

    sweep #(.N(N)) sweep (
        .i_clk         (i_clk),
        .i_rst         (i_rst),
        .i_load        (i_load),
        .i_quadrant    (i_quadrant),
        .i_crossings   (i_crossings),
        .i_cw          (i_cw),
        .i_jex         (i_jex),
        .i_jey         (i_jey),
        .i_en          (run),
        .i_px          (px),
        .i_nx          (sx),
        .i_py          (py),
        .i_ny          (sy),
        .i_x_is_zero   (o_jvy == 0),
        .i_y_is_zero   (o_jvx == 0),
        .i_x_gets_zero (jvy_next == 0),
        .i_y_gets_zero (jvx_next == 0),
        .o_towards_is_y(towards_is_y),
        .o_nx          (nx),
        .o_ny          (ny),
        .o_x_stands    (x_stands),
        .o_y_stands    (y_stands),
        .o_stepping_out(stepping_out),
        .o_done        (o_done),
        .o_quadrant    (o_quadrant),
        .o_crossings   (o_crossings),
        .o_cw          (o_cw),
        .o_jex         (o_jex),
        .o_jey         (o_jey)
    );

    always @(posedge i_clk)
        if (i_rst) begin
            o_unit <= {N{1'b0}};
            o_jvx <= {N{1'b0}};
            o_jvy <= {N{1'b0}};
        end else if (i_load) begin
            o_unit <= i_unit;
            o_jvx <= i_jvx;
            o_jvy <= i_jvy;
        end else begin
            o_jvx <= jvx_next;
            o_jvy <= jvy_next;
        end
endmodule
