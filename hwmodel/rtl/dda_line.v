// Straight line by digital integration: an integrator an axis, one counter for all.
//
// JV = |end| shifted left by Q, JE = 2^(N-Q) accumulations: after those each axis has had exactly
// |end| pulses, whatever the preset.
module dda_line #(
    parameter N    = 24,
    parameter AXES = 2
) (
    input  wire              i_clk,
    input  wire              i_rst,
    // pulse source
    input  wire              i_en,
    // command: the registers' first contents
    input  wire              i_load,
    input  wire [AXES*N-1:0] i_jv,
    input  wire [N-1:0]      i_preset,
    input  wire [N:0]        i_je,
    input  wire [AXES-1:0]   i_negative,
    // pulses of this clock, and their directions
    output wire [AXES-1:0]   o_pulse,
    output reg  [AXES-1:0]   o_negative,
    output wire              o_done,
    // registers
    output reg  [AXES*N-1:0] o_jv,
    output wire [AXES*N-1:0] o_jr,
    output reg  [N:0]        o_je
);
    wire [AXES-1:0] carry;
    wire            run = i_en & ~o_done;

    assign o_done  = o_je == 0;
    assign o_pulse = carry & {AXES{run}};

    genvar axis;
    generate
        for (axis = 0; axis < AXES; axis = axis + 1) begin : axes
            integrator #(.N(N)) integrator (
                .i_clk   (i_clk),
                .i_rst   (i_rst),
                .i_load  (i_load),
                .i_preset(i_preset),
                .i_en    (run),
                .i_jv    (o_jv[axis*N +: N]),
                .o_carry (carry[axis]),
                .o_jr    (o_jr[axis*N +: N])
            );
        end
    endgenerate

    always @(posedge i_clk)
        if (i_rst) begin
            o_jv       <= {AXES*N{1'b0}};
            o_je       <= {(N+1){1'b0}};
            o_negative <= {AXES{1'b0}};
        end else if (i_load) begin
            o_jv       <= i_jv;
            o_je       <= i_je;
            o_negative <= i_negative;
        end else if (run)
            o_je <= o_je - 1'b1;
endmodule
