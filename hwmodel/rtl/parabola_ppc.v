// Parabola from its vertex by point-by-point comparison: one step a clock.
//
// u goes along the axis of symmetry, v across it, both in magnitudes. F = v^2 - 2|p|u: on the parabola or
// outside u is fed and takes 2|p| from F, inside v is fed and adds 2v + 1. An axis with a spent counter
// stands and the other is fed whatever F says; from then on F may wrap. What is taken goes into the
// adder inverted, with a carry.
module parabola_ppc #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // pulse source
    input  wire         i_en,
    // command: |p|, the end point's magnitudes, and whether the axis of symmetry is y
    input  wire         i_load,
    input  wire [N-1:0] i_p,
    input  wire [N-1:0] i_end_along,
    input  wire [N-1:0] i_end_across,
    input  wire         i_axis_is_y,
    input  wire [1:0]   i_negative,
    // pulses of this clock, and their directions
    output wire [1:0]   o_pulse,
    output reg  [1:0]   o_negative,
    output wire         o_done,
    // registers
    output reg  [N+1:0] o_f,
    output reg  [N-1:0] o_v,
    output reg  [N-1:0] o_p,
    output reg  [N-1:0] o_je_along,
    output reg  [N-1:0] o_je_across,
    output reg          o_axis_is_y
);
    wire         stands_along  = o_je_along == 0;
    wire         stands_across = o_je_across == 0;
    wire         along         = (~o_f[N+1] & ~stands_along) | stands_across;
    wire         pulse_is_y    = along == o_axis_is_y;
    wire         run           = i_en & ~o_done;
    wire [N+1:0] change        = along ? ~{1'b0, o_p, 1'b0} : {1'b0, o_v, 1'b1};

    assign o_done  = stands_along & stands_across;
    assign o_pulse = {pulse_is_y, ~pulse_is_y} & {2{run}};

    always @(posedge i_clk)
        if (i_rst) begin
            o_f         <= {(N+2){1'b0}};
            o_v         <= {N{1'b0}};
            o_p         <= {N{1'b0}};
            o_je_along  <= {N{1'b0}};
            o_je_across <= {N{1'b0}};
            o_axis_is_y <= 1'b0;
            o_negative  <= 2'b00;
        end else if (i_load) begin
            o_f         <= {(N+2){1'b0}};
            o_v         <= {N{1'b0}};
            o_p         <= i_p;
            o_je_along  <= i_end_along;
            o_je_across <= i_end_across;
            o_axis_is_y <= i_axis_is_y;
            o_negative  <= i_negative;
        end else if (run) begin
            o_f         <= o_f + change + {{(N+1){1'b0}}, along};
            o_v         <= o_v + {{(N-1){1'b0}}, ~along};
            o_je_along  <= o_je_along - {{(N-1){1'b0}}, along};
            o_je_across <= o_je_across - {{(N-1){1'b0}}, ~along};
        end
endmodule
