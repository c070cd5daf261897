// What a DDA line always does, for every command and every pattern of the pulse source.
//
// Proved by induction: the asserts are the invariant. The ghosts keep what the circuit forgets,
// in registers wide enough not to wrap before the counter runs out.
module dda_line_props #(
    parameter N = 24
) (
    input wire           clk,
    input wire           en,
    input wire           load,
    input wire [2*N-1:0] jv,
    input wire [N-1:0]   preset,
    input wire [N:0]     je
);
    localparam M = 2*N + 2;

    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire [1:0]     pulse, negative;
    wire           done;
    wire [2*N-1:0] jv_q, jr_q;
    wire [N:0]     je_q;

    dda_line #(.N(N), .AXES(2)) line (
        .i_clk(clk), .i_rst(first), .i_en(en), .i_load(load), .i_jv(jv), .i_preset(preset),
        .i_je(je), .i_negative(2'b00), .o_pulse(pulse), .o_negative(negative), .o_done(done),
        .o_jv(jv_q), .o_jr(jr_q), .o_je(je_q)
    );

    reg [N:0]   loaded = 0, clocks = 0;
    reg [M-1:0] sum_x = 0, sum_y = 0, pulses_x = 0, pulses_y = 0;
    always @(posedge clk)
        if (first | load) begin
            loaded   <= first ? 0 : je;
            clocks   <= 0;
            sum_x    <= first ? 0 : {{(M-N){1'b0}}, preset};
            sum_y    <= first ? 0 : {{(M-N){1'b0}}, preset};
            pulses_x <= 0;
            pulses_y <= 0;
        end else if (en & ~done) begin
            clocks   <= clocks + 1'b1;
            sum_x    <= sum_x + {{(M-N){1'b0}}, jv_q[N-1:0]};
            sum_y    <= sum_y + {{(M-N){1'b0}}, jv_q[2*N-1:N]};
            pulses_x <= pulses_x + {{(M-1){1'b0}}, pulse[0]};
            pulses_y <= pulses_y + {{(M-1){1'b0}}, pulse[1]};
        end

    always @* if (!first) begin
        // No pulse once the accumulations are made, nor without the pulse source.
        assert (!((done | ~en) & pulse != 0));
        // Done after exactly the loaded number of accumulations.
        assert (clocks + je_q == loaded);
        // The overflow is the pulse: pulses * 2^N + JR is the exact sum.
        assert ((pulses_x << N) + {{(M-N){1'b0}}, jr_q[N-1:0]} == sum_x);
        assert ((pulses_y << N) + {{(M-N){1'b0}}, jr_q[2*N-1:N]} == sum_y);
    end
endmodule
